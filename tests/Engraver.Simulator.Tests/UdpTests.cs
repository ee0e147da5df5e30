using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Engraver.Simulator.Tests;

/// <summary>Commands and data records by datagram (galil-dmc.md A.1, A.9, L.2 point 6).</summary>
public sealed class UdpTests : IDisposable
{
    /// <summary>Created for each test: on a busy machine a test may start long after the class.</summary>
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(60));

    private CancellationToken Soon => _limit.Token;

    public void Dispose() => _limit.Dispose();

    [Fact]
    public async Task A_datagram_is_a_command_on_a_handle_of_its_own()
    {
        await using var rig = new SimulatorRig();
        using var client = await ConnectAsync(rig);

        Assert.Equal("IHB\r\n:", await AskAsync(client, "WH\r"));
        Assert.Equal("IHB\r\n:", await AskAsync(client, "WH;"));
        var port = ((IPEndPoint)client.Client.LocalEndPoint!).Port;
        Assert.Contains($"IHB UDP PORT {((IPEndPoint)client.Client.RemoteEndPoint!).Port} TO IP ADDRESS 127,0,0,1 PORT {port}", rig.Ask("TH"));
        Assert.Equal((1, 2), (rig.Value("_IHB2"), rig.Value("_IHA2")));
        rig.Do("IHT=>-1");
        Assert.Equal(0, rig.Value("_IHB2"));
    }

    [Fact]
    public async Task Records_are_pushed_without_a_prompt_until_DR_0()
    {
        await using var rig = new SimulatorRig();
        using var client = await ConnectAsync(rig);
        await AskAsync(client, "WH\r");

        rig.Do("DR 10,1").Pass(25);

        Assert.Equal((10, 1), (rig.Value("_DR0"), rig.Value("_DR1")));
        var first = (await client.ReceiveAsync(Soon)).Buffer;
        var second = (await client.ReceiveAsync(Soon)).Buffer;
        Assert.Equal((156, 0x87, 0x0F), (first.Length, first[0], first[1]));
        Assert.Equal(10, BitConverter.ToUInt16(second, 4) - BitConverter.ToUInt16(first, 4));
        rig.Do("DR 0");
        Assert.Equal(0, rig.Value("_DR0"));
    }

    [Fact]
    public async Task Too_short_a_period_and_a_TCP_handle_are_refused()
    {
        await using var rig = new SimulatorRig();
        using var client = await ConnectAsync(rig);
        await AskAsync(client, "WH\r");

        Assert.Equal((6, 133, 133), (rig.Refusal("DR 7,1"), rig.Refusal("DR 10,0"), rig.Refusal("DR 10")));
    }

    private async Task<UdpClient> ConnectAsync(SimulatorRig rig)
    {
        var place = await rig.Controller.ListenUdpAsync(0, Soon);
        var client = new UdpClient(new IPEndPoint(IPAddress.Loopback, 0));
        client.Connect(place);
        return client;
    }

    private async Task<string> AskAsync(UdpClient client, string command)
    {
        await client.SendAsync(Encoding.Latin1.GetBytes(command), Soon);
        return Encoding.Latin1.GetString((await client.ReceiveAsync(Soon)).Buffer);
    }
}
