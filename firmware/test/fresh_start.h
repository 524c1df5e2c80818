/// The sketch's memory as it is after a reset. To be included behind the sketch.

#pragma once

#if defined(__arm__)
inline void* operator new(size_t, void* place) { return place; }
#else
#include <new>
#endif

inline void build_anew() {
  new (&bus) WireBus();
  new (&encoder) Kinds::Encoder(EncoderOf::link(bus, encoder_link));
  new (&imu) Kinds::Imu(bus);
  new (&can) Can(can_link);
  new (&uplink) Kinds::Link(can, usb);
  new (&node)
      exoid::TendedNode<Kinds>({encoder, imu, uplink, flash, own, timer, condition});
}
