using Engraver.Core.Machines;
using Engraver.Links.Serial;
using Engraver.TestKit;

namespace Engraver.Links.Tests.Serial;

/// <summary>The link on a pseudo-terminal without a controller, with System.IO.Ports.</summary>
public sealed class PortsLinkTests() : SerialLinkTests(SerialDriver.Ports)
{
    /// <summary>The other side has stopped the line with XOFF, so that a write of the library ends only by its own time-out, of a minute here.</summary>
    [Fact]
    public async Task A_device_that_cannot_be_closed_is_not_waited_for_and_reported_as_locked()
    {
        ControllerLinkException? refused = null;
        for (var attempt = 0; attempt < 50 && refused is null; attempt++)
        {
            using var cable = new PseudoTerminalPair();
            var time = new ManualTimeProvider();
            var address = new SerialAddress(cable.Device, 19200, SerialFlow.XonXoff) { Driver = SerialDriver.Ports };
            var link = SerialLink.Open(address, TimeSpan.FromSeconds(60), time);
            cable.Write("\u0013A");
            Assert.Equal("A", await ReadAsync(link, 1)); // the system has processed XOFF
            var writing = link.WriteAsync("TP\r"u8.ToArray(), CancellationToken.None).AsTask();
            await Task.Yield();

            var closing = link.DisposeAsync().AsTask();
            await Assert.ThrowsAsync<IOException>(() => writing.WaitAsync(Patience));
            while (!closing.IsCompleted)
            {
                time.Advance(TimeSpan.FromSeconds(0.1));
                await Task.Yield();
            }

            // If the thread had not started the write, the device was closed at once, and the next attempt counts.
            refused = await Record.ExceptionAsync(async () =>
            {
                await using var again = SerialLink.Open(address, TimeSpan.FromSeconds(60), TimeProvider.System);
            }) as ControllerLinkException;
        }

        Assert.Contains("a closed link of this program still has it locked", refused?.Message, StringComparison.Ordinal);
    }
}
