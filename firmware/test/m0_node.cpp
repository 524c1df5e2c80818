// The whole node on an emulated Cortex-M0: register models of the sensors are exposed to the
// records of samples.bin, one a tick from when the host opens the channel; the last one stays.

#include "chips.h"
#include "node.h"
#include "nrf51_clock.h"
#include "nrf51_uart.h"
#include "semihosting.h"
#include "systick.h"
#include "uplink.h"

namespace {

constexpr uint32_t WARM_UP = 20;  // ticks before a host is heard; the gyro is then settled
constexpr uint32_t NAP = 1000 * exoid::SYSTICK_PER_US;  // counts between looks at clock and host

struct NoCan {
  void begin() {}
  void poll(uint32_t) {}
  bool is_up() const { return false; }
  bool send(const exoid::Frame&) { return true; }
};

struct Well {
  void describe(exoid::Health&) const {}
};

/// What the sensors are exposed to at each tick.
class Stream {
 public:
  explicit Stream(semihosting::File& file) : file_(file) { file_.read(&now_, sizeof now_); }

  void start() { running_ = true; }

  const chips::Exposure& next() {
    chips::Exposure read;
    if (running_ && used_ && file_.read(&read, sizeof read)) now_ = read;
    used_ = running_;
    return now_;
  }

 private:
  semihosting::File& file_;
  chips::Exposure now_ = {};
  bool running_ = false;
  bool used_ = false;
};

using Encoder = exoid::As5600<chips::Board>;
using Imu = exoid::Lsm6ds3<chips::Board>;
using Link = exoid::Uplink<NoCan, exoid::Nrf51Uart>;

chips::Board board;
Encoder encoder(board);
Imu imu(board);
NoCan no_can;
exoid::Nrf51Uart uart;
Link uplink(no_can, uart);
exoid::Nrf51Clock timer;
Well well;
exoid::Node<Encoder, Imu, Link, exoid::Nrf51Clock, Well> node(encoder, imu, uplink, timer, well);

}  // namespace

int main() {
  semihosting::File file("samples.bin", 11, semihosting::READ_BINARY);
  Stream stream(file);
  uart.begin();
  uplink.begin();
  timer.begin();
  exoid::systick_begin(NAP);
  for (uint32_t tick = 0;;) {
    if (!timer.advance()) asm volatile("wfi");
    if (tick != timer.ticks()) {
      tick = timer.ticks();
      board.expose(stream.next());
    }
    node.run();
    if (tick >= WARM_UP && uplink.poll(tick * exoid::TICK_US / 1000)) {
      node.restart();
      stream.start();
    }
  }
}
