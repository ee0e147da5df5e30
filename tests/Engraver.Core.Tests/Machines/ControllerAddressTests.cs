using Engraver.Core.Machines;

namespace Engraver.Core.Tests.Machines;

public class ControllerAddressTests
{
    [Fact]
    public void Each_scheme_is_read_with_its_defaults()
    {
        Assert.Equal(new TcpAddress("10.0.0.5", 5000), ControllerAddress.Parse("tcp://10.0.0.5:5000"));
        Assert.Equal(new TcpAddress("engraver", 23), ControllerAddress.Parse("tcp://engraver"));
        Assert.Equal(new SerialAddress("/dev/ttyS0", 19200), ControllerAddress.Parse("serial:///dev/ttyS0"));
        Assert.Equal(new SerialAddress("COM3", 9600), ControllerAddress.Parse("serial://COM3?baud=9600"));
        Assert.Equal(new SerialAddress("/dev/ttyUSB0", 115200, SerialFlow.None), ControllerAddress.Parse("serial:///dev/ttyUSB0?baud=115200&flow=none"));
        Assert.Equal(new SerialAddress("/dev/ttyS0", 19200, SerialFlow.XonXoff), ControllerAddress.Parse("serial:///dev/ttyS0?flow=xonxoff"));
        Assert.Equal(new SerialAddress("/dev/ttyS0", 19200, SerialFlow.RtsCts), ControllerAddress.Parse("serial:///dev/ttyS0?flow=rtscts"));
        Assert.Equal(new SerialAddress("/dev/ttyS0", 9600) { Driver = SerialDriver.Ports }, ControllerAddress.Parse("serial:///dev/ttyS0?driver=ports&baud=9600"));
        Assert.Equal(new SerialAddress("/dev/ttyS0", 19200) { Driver = SerialDriver.Own }, ControllerAddress.Parse("/dev/ttyS0?driver=own"));
        Assert.Equal(new SimulatedAddress(double.PositiveInfinity) { HasExplicitSpeed = false }, ControllerAddress.Parse("sim:"));
        Assert.Equal(new SimulatedAddress(double.PositiveInfinity), ControllerAddress.Parse("sim:?speed=max"));
        Assert.Equal(new SimulatedAddress(2.5), ControllerAddress.Parse("sim:?speed=2.5"));
    }

    /// <summary>Addresses as typed, and their meaning.</summary>
    [Theory]
    [InlineData("192.168.0.2", "tcp://192.168.0.2:23")]
    [InlineData("192.168.0.2:5000", "tcp://192.168.0.2:5000")]
    [InlineData(" 192.168.0.2 ", "tcp://192.168.0.2:23")]
    [InlineData("engraver.local", "tcp://engraver.local:23")]
    [InlineData("engraver.local:1234", "tcp://engraver.local:1234")]
    [InlineData("localhost", "tcp://localhost:23")]
    [InlineData("[::1]:23", "tcp://[::1]:23")]
    [InlineData("TCP://10.0.0.5", "tcp://10.0.0.5:23")]
    [InlineData("COM3", "serial://COM3?baud=19200")]
    [InlineData("com12?baud=9600", "serial://com12?baud=9600")]
    [InlineData("/dev/ttyUSB0", "serial:///dev/ttyUSB0?baud=19200")]
    [InlineData("sim", "sim:")]
    [InlineData("SIM:", "sim:")]
    [InlineData("sim?speed=2.5", "sim:?speed=2.5")]
    public void An_address_without_its_scheme_is_taken_where_it_tells_what_it_is(string text, string address) => Assert.Equal(address, ControllerAddress.Parse(text).Typed);

    [Theory]
    [InlineData("tcp://10.0.0.5:5000")]
    [InlineData("serial:///dev/ttyS0?baud=9600")]
    [InlineData("serial://COM3?baud=115200&flow=none")]
    [InlineData("serial:///dev/ttyS0?baud=19200&flow=xonxoff")]
    [InlineData("serial:///dev/ttyS0?baud=19200&driver=ports")]
    [InlineData("serial:///dev/ttyS0?baud=9600&flow=none&driver=own")]
    [InlineData("sim:")]
    [InlineData("sim:?speed=2.5")]
    public void An_address_is_told_as_it_is_typed(string text) => Assert.Equal(text, ControllerAddress.Parse(text).Typed);

    [Theory]
    [InlineData("")]
    [InlineData("engraver")]
    [InlineData("simm")]
    [InlineData("usb:1")]
    [InlineData("tcp:23")]
    [InlineData("COM")]
    [InlineData("COM3x")]
    [InlineData("10.0.0.5:0")]
    [InlineData("10.0.0.5:port")]
    [InlineData("http://10.0.0.5")]
    [InlineData("10.0.0.5/path")]
    [InlineData("ttyUSB0:")]
    [InlineData("tcp://")]
    [InlineData("tcp://host:0")]
    [InlineData("tcp://host:70000")]
    [InlineData("tcp://host:23/path")]
    [InlineData("serial://")]
    [InlineData("serial://COM3?baud=fast")]
    [InlineData("serial://COM3?baud=19201")]
    [InlineData("serial://COM3?flow=maybe")]
    [InlineData("serial://COM3?parity=even")]
    [InlineData("sim:?speed=-1")]
    [InlineData("sim:?speed=1,5")]
    public void What_is_no_address_is_refused_with_the_forms_that_are(string text)
    {
        var refusal = Assert.Throws<FormatException>(() => ControllerAddress.Parse(text));

        Assert.Contains("tcp://HOST:PORT", refusal.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("usb")]
    [InlineData("")]
    [InlineData("Ports")]
    public void An_unknown_driver_is_named_with_those_that_exist(string driver)
    {
        var refused = Assert.Throws<FormatException>(() => ControllerAddress.Parse($"serial://COM3?driver={driver}&baud=9600"));

        Assert.Equal($"'serial://COM3?driver={driver}&baud=9600': '{driver}' is not a driver of serial devices. Use one of own, ports, or omit driver=.", refused.Message);
    }
}
