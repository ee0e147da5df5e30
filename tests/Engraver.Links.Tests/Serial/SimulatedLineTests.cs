using System.Text;
using Engraver.Core.Machines;
using Engraver.Links.Serial;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Links.Tests.Serial;

/// <summary>The serial line of a simulated controller takes ten bit times at its rate for each byte, unless the timing of its bytes is switched off.</summary>
public sealed class SimulatedLineTests : IDisposable
{
    private const int Baud = 9600;
    private const string Command = "MG 4711\r";

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-line-");
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(60));
    private readonly ManualTimeProvider _wall = new();

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task Its_bytes_take_their_time_or_none(bool atOnce)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 1, Time = _wall });
        var device = Path.Combine(_folder.FullName, "line");
        await controller.ServeSerialAsync(device, Baud, _limit.Token);
        controller.IsSerialInstant = atOnce;
        await using var line = SerialLink.Open(new SerialAddress(device, Baud), TimeSpan.FromSeconds(60), TimeProvider.System);
        var begun = _wall.GetTimestamp();

        await line.WriteAsync(Encoding.ASCII.GetBytes(Command), _limit.Token);
        var answer = AnswerAsync(line);
        while (!atOnce && !answer.IsCompleted)
        {
            _limit.Token.ThrowIfCancellationRequested();
            _wall.Advance(TimeSpan.FromMilliseconds(0.25));
            await Task.Yield();
        }

        var heard = await answer.WaitAsync(_limit.Token); // at once: the wall clock does not advance
        var least = TimeSpan.FromSeconds(10.0 * heard.Length / Baud); // the echo is sent back at the same time as the command
        Assert.Contains("4711", heard, StringComparison.Ordinal);
        Assert.True(atOnce ? _wall.GetElapsedTime(begun) == TimeSpan.Zero : _wall.GetElapsedTime(begun) >= least, $"{_wall.GetElapsedTime(begun)} for {heard.Length} bytes");
    }

    /// <summary>Regression: the link was removed at the first disconnection, and hosts could not connect again.</summary>
    [Theory]
    [InlineData(FaultKind.Reset, "7.0000")]
    [InlineData(FaultKind.PowerCycle, "?")]
    public async Task A_port_whose_cable_was_pulled_comes_back_at_its_path(FaultKind fault, string answer)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = _wall });
        var device = new FileInfo(Path.Combine(_folder.FullName, "line"));
        await controller.ServeSerialAsync(device.FullName, Baud, _limit.Token);
        for (var times = 0; times < 2; times++)
        {
            await using var line = SerialLink.Open(new SerialAddress(device.FullName, Baud), TimeSpan.FromSeconds(60), TimeProvider.System);
            await line.WriteAsync("x=7\r"u8.ToArray(), _limit.Token);
            Assert.Equal("x=7\r:", await AnswerAsync(line));

            controller.Schedule(new ScheduledFault { Kind = fault, AtByte = 0 });

            await Assert.ThrowsAsync<IOException>(() => AnswerAsync(line));
            for (device.Refresh(); device.LinkTarget is null; device.Refresh()) // the old one was removed before the hang-up
            {
                _limit.Token.ThrowIfCancellationRequested();
                await Task.Yield();
            }
        }

        await using var again = SerialLink.Open(new SerialAddress(device.FullName, Baud), TimeSpan.FromSeconds(60), TimeProvider.System);
        await again.WriteAsync("MG x\r"u8.ToArray(), _limit.Token);
        Assert.Contains(answer, await AnswerAsync(again), StringComparison.Ordinal);
        await controller.DisposeAsync();
        device.Refresh();
        Assert.Null(device.LinkTarget);
    }

    public void Dispose()
    {
        _folder.Delete(recursive: true);
        _limit.Dispose();
    }

    /// <summary>The echo and the reply, up to its prompt.</summary>
    private async Task<string> AnswerAsync(ISerialLink line)
    {
        var heard = new StringBuilder();
        var some = new byte[64];
        while (!heard.ToString().EndsWith(':') && !heard.ToString().EndsWith('?')) heard.Append(Encoding.ASCII.GetString(some, 0, await line.ReadAsync(some, _limit.Token)));
        return heard.ToString();
    }
}
