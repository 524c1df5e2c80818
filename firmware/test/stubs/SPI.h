/// Arduino's SPI bus; the model of the CAN controller needs nothing of it.

#pragma once

class SPIClass {
 public:
  void begin() {}
};

extern SPIClass SPI;
