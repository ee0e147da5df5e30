using System.Text;

namespace Engraver.Simulator.Tests.Protocol;

/// <summary>The main serial port (galil-dmc.md A.1, A.2, A.5).</summary>
public class SerialPortTests
{
    [Fact]
    public async Task Characters_are_echoed_until_EO_0()
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);

        Assert.Equal("MG 1\r 1.0000\r\n:", SimulatorRig.Exchange(serial, "MG 1\r"));
        Assert.Equal("EO 0\r:", SimulatorRig.Exchange(serial, "EO 0\r"));
        Assert.Equal(" 1.0000\r\n:", SimulatorRig.Exchange(serial, "MG 1\r"));
        Assert.Equal(" 0.0000\r\n:", SimulatorRig.Exchange(serial, "MG _EO\r"));
        Assert.Equal(":", SimulatorRig.Exchange(serial, "EO 1\r"));
        Assert.Equal("EO ?\r 1\r\n:", SimulatorRig.Exchange(serial, "EO ?\r"));
    }

    [Fact]
    public async Task EO_is_refused_over_Ethernet_and_a_reset_brings_the_echo_back()
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);

        Assert.Equal(1, rig.Refusal("EO 0"));
        Assert.EndsWith(":", SimulatorRig.Exchange(serial, "EO 0\r"));
        Assert.EndsWith(":", SimulatorRig.Exchange(serial, "RS\r"));
        Assert.Equal("MG 1\r 1.0000\r\n:", SimulatorRig.Exchange(serial, "MG 1\r"));
    }

    [Fact]
    public async Task The_port_says_that_it_is_none_of_the_handles()
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        SimulatorRig.Exchange(serial, "EO 0\r");

        Assert.Equal("RS232\r\n:", SimulatorRig.Exchange(serial, "WH\r"));
        Assert.Equal(" -1.0000\r\n:", SimulatorRig.Exchange(serial, "MG _WH\r"), ignoreAllWhiteSpace: true);
        Assert.Equal(1, rig.Controller.Status.OpenHandles);
    }

    [Fact]
    public async Task Messages_come_to_the_serial_port_unless_CF_sends_them_elsewhere()
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        SimulatorRig.Exchange(serial, "EO 0\rCW 1\r");
        rig.Download("#A\nMG \"HI\"\nMG {P1}\"YO\"\nEN");

        rig.Do("XQ #A").RunToIdle();
        var said = SimulatorRig.ReadAvailable(serial);
        rig.Do("CF I").Ask("XQ #A");
        rig.RunToIdle();

        Assert.Equal("HI\r\nYO\r\n", Plain(said));
        Assert.Equal("YO\r\n", Plain(SimulatorRig.ReadAvailable(serial)));
        Assert.Equal(":", SimulatorRig.Exchange(serial, "CF I\r"));
        Assert.Equal((double)'S', rig.Value("_CF"));
    }

    [Theory]
    [InlineData(19200)]
    [InlineData(1200)]
    public async Task Every_byte_takes_ten_bits_both_ways(int baud)
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(baud);
        SimulatorRig.Exchange(serial, "EO 0\r");
        var before = rig.Controller.Status.Sample;

        for (var i = 0; i < 100; i++) Assert.Equal(" 1.0000\r\n:", SimulatorRig.Exchange(serial, "MG 1\r"));

        Assert.InRange(rig.Controller.Status.Sample - before, (100 * 15 * 10_000.0 / baud) - 1, (100 * 15 * 10_000.0 / baud) + 1);
    }

    [Fact]
    public async Task Two_hosts_cannot_share_the_cable_but_take_turns()
    {
        await using var rig = new SimulatorRig();
        var first = rig.Controller.OpenSerialConnection(19200);

        Assert.Throws<IOException>(() => rig.Controller.OpenSerialConnection(19200));
        await first.DisposeAsync();
        await using var second = rig.Controller.OpenSerialConnection(9600);
        Assert.EndsWith(":", SimulatorRig.Exchange(second, "\r"));
    }

    private static string Plain(string marked)
    {
        Assert.All(marked, character => Assert.True(character >= 0x80));
        return Encoding.ASCII.GetString([.. marked.Select(character => (byte)(character - 0x80))]);
    }
}
