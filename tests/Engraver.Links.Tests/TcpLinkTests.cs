using System.Net;
using System.Net.Sockets;
using Engraver.Core.Machines;

namespace Engraver.Links.Tests;

public class TcpLinkTests
{
    [Fact]
    public async Task A_port_where_nobody_listens_is_a_link_that_never_came_up()
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        var port = ((IPEndPoint)listener.LocalEndpoint).Port;
        listener.Stop();

        var failure = await Assert.ThrowsAsync<ControllerLinkException>(
            () => TcpLink.ConnectAsync("127.0.0.1", port, TimeSpan.FromSeconds(5), TimeProvider.System, CancellationToken.None));

        Assert.Contains($"tcp://127.0.0.1:{port}", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Bytes_go_both_ways_and_the_end_of_the_other_side_reads_as_nothing()
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        var accepting = listener.AcceptTcpClientAsync();
        await using var link = await TcpLink.ConnectAsync("127.0.0.1", ((IPEndPoint)listener.LocalEndpoint).Port, TimeSpan.FromSeconds(60), TimeProvider.System, CancellationToken.None);
        var buffer = new byte[16];

        using (var other = await accepting)
        {
            await link.WriteAsync("TP\r"u8.ToArray(), CancellationToken.None);
            await other.GetStream().ReadExactlyAsync(buffer.AsMemory(0, 3));
            await other.GetStream().WriteAsync(":"u8.ToArray());
            Assert.Equal("TP\r"u8, buffer.AsSpan(0, 3));
            Assert.Equal(1, await link.ReadAsync(buffer, CancellationToken.None));
        }

        Assert.Equal(0, await link.ReadAsync(buffer, CancellationToken.None));
    }
}
