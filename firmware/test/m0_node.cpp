// The whole node on an emulated Cortex-M0: register models of the sensors are exposed to the
// records of samples.bin, one a tick from when the host opens the channel; the last one stays. What
// it stores is kept in the files slot0.bin to slot2.bin, its serial number is that of board.bin.

#include "as5600.h"
#include "chips.h"
#include "host_board.h"
#include "lsm6ds3.h"
#include "nrf51_clock.h"
#include "nrf51_uart.h"
#include "semihosting.h"
#include "systick.h"
#include "tended_node.h"
#include "uplink.h"

namespace {

constexpr uint32_t WARM_UP = 20;  // ticks before a host is heard; the gyro is then settled
constexpr uint32_t NAP = 1000 * exoid::SYSTICK_PER_US;  // counts between looks at clock and host

struct NoCan {
  void begin(uint32_t) {}
  void poll(uint32_t) {}
  bool is_up() const { return false; }
  bool send(const exoid::Frame&) { return true; }
  bool receive(exoid::Frame&) { return false; }
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

exoid::Nrf51Clock timer;

/// Hears the host once the gyro has settled, and begins the motion when the host opens the channel.
class PatientLink {
 public:
  PatientLink(Stream& stream, exoid::Nrf51Uart& uart) : stream_(stream), link_(no_can_, uart) {}

  void begin(uint32_t bit_rate) { link_.begin(bit_rate); }

  bool poll(uint32_t now_ms) {
    if (!patient_ || timer.ticks() < WARM_UP || !link_.poll(now_ms)) return false;
    stream_.start();
    return true;
  }

  bool send(const exoid::Frame& frame) { return link_.send(frame); }
  bool receive(exoid::Frame& frame) { return link_.receive(frame); }
  bool is_on_can() const { return link_.is_on_can(); }

  /// While the sample of a tick is still to be taken, nobody is heard.
  void wait_for_sample(bool waits) { patient_ = !waits; }

 private:
  Stream& stream_;
  NoCan no_can_;
  exoid::Uplink<NoCan, exoid::Nrf51Uart> link_;
  bool patient_ = false;
};

struct Kinds {
  using Encoder = exoid::As5600<chips::Board>;
  using Imu = exoid::Lsm6ds3<chips::Board>;
  using Link = PatientLink;
  using Flash = exoid::HostFlash;
  using Board = exoid::HostBoard;
  using Clock = exoid::Nrf51Clock;
  using Condition = Well;
};

chips::Board chips_on_bus;
Kinds::Encoder encoder(chips_on_bus);
Kinds::Imu imu(chips_on_bus);
exoid::Nrf51Uart uart;
Kinds::Flash flash;
Kinds::Board board;
Well well;

}  // namespace

int main() {
  semihosting::File file("samples.bin", 11, semihosting::READ_BINARY);
  Stream stream(file);
  PatientLink link(stream, uart);
  exoid::TendedNode<Kinds> node({encoder, imu, link, flash, board, timer, well});
  uart.begin();
  node.begin();
  timer.begin();
  exoid::systick_begin(NAP);
  for (uint32_t tick = 0;;) {
    if (!timer.advance()) asm volatile("wfi");
    const bool ticked = tick != timer.ticks();
    if (ticked) {
      tick = timer.ticks();
      chips_on_bus.expose(stream.next());
    }
    link.wait_for_sample(ticked);
    node.run(tick * exoid::TICK_US / 1000);
  }
}
