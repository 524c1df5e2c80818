/// Which driver a part of config.h has, and what it hangs on.

#pragma once

#include "as504x.h"
#include "as5600.h"
#include "icm42688p.h"
#include "lsm6ds3.h"
#include "parts.h"

namespace exoid {

template <EncoderPart PART, class Bus, class Spi>
struct EncoderOf;

template <class Bus, class Spi>
struct EncoderOf<EncoderPart::AS5600, Bus, Spi> {
  using Driver = As5600<Bus>;
  static Bus& link(Bus& bus, Spi&) { return bus; }
};

template <class Bus, class Spi>
struct EncoderOf<EncoderPart::AS5047P, Bus, Spi> {
  using Driver = As504x<Spi, As5047pMap>;
  static Spi& link(Bus&, Spi& spi) { return spi; }
};

template <class Bus, class Spi>
struct EncoderOf<EncoderPart::AS5048A, Bus, Spi> {
  using Driver = As504x<Spi, As5048aMap>;
  static Spi& link(Bus&, Spi& spi) { return spi; }
};

template <ImuPart PART, class Bus>
struct ImuOf;

template <class Bus>
struct ImuOf<ImuPart::LSM6DS3, Bus> {
  using Driver = Lsm6ds3<Bus>;
};

template <class Bus>
struct ImuOf<ImuPart::ICM42688P, Bus> {
  using Driver = Icm42688p<Bus>;
};

}  // namespace exoid
