using Engraver.Core.Machines;
using Engraver.Links.Serial;

namespace Engraver.Links.Tests.Serial;

/// <summary>Which driver opens an address, on this system and on others.</summary>
public class SerialDriverTests
{
    /// <param name="hasOwn">Linux.</param>
    /// <param name="hasPorts">Windows, macOS and Linux.</param>
    [Theory]
    [InlineData(true, true, null, null)]
    [InlineData(true, true, SerialDriver.Own, null)]
    [InlineData(true, true, SerialDriver.Ports, null)]
    [InlineData(false, true, null, null)]
    [InlineData(false, true, SerialDriver.Ports, null)]
    [InlineData(false, true, SerialDriver.Own, "COM3 cannot be opened with driver=own, which is for Linux. Omit it, or use driver=ports.")]
    [InlineData(true, false, SerialDriver.Ports, "COM3 cannot be opened with driver=ports on this computer. Omit it, or connect the controller by tcp://HOST:PORT.")]
    [InlineData(false, false, null, "Serial links are supported on Linux, Windows and macOS only. Connect the controller by tcp://HOST:PORT.")]
    public void A_driver_that_the_system_lacks_is_refused_with_what_to_do(bool hasOwn, bool hasPorts, SerialDriver? driver, string? refusal) =>
        Assert.Equal(refusal, SerialLink.WhyUnsupported(new SerialAddress("COM3", 19200) { Driver = driver }, hasOwn, hasPorts));

    [Fact]
    public void Names_of_ports_are_listed_once_in_the_order_of_their_numbers_and_without_those_that_wait_for_a_carrier() => Assert.Equal(
        ["/dev/cu.modem", "/dev/cu.usbserial-2", "/dev/cu.usbserial-10", "COM3", "COM10"],
        SerialDeviceList.Ordered(["COM10", "COM3", "/dev/tty.usbserial-2", "/dev/cu.usbserial-10", "/dev/cu.usbserial-2", "/dev/cu.modem", "COM3"]));
}
