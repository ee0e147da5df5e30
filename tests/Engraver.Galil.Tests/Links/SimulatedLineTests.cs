using System.Text;
using Engraver.Core.Machines;
using Engraver.Galil.Links;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Links;

/// <summary>The serial line of a simulated controller takes ten bits at its rate for each byte, unless it is told that what it carries is of no interest.</summary>
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
        controller.SerialCarriesAtOnce = atOnce;
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

        var heard = await answer.WaitAsync(_limit.Token); // at once: while the wall stands still
        var least = TimeSpan.FromSeconds(10.0 * heard.Length / Baud); // the echo goes back beside the command
        Assert.Contains("4711", heard, StringComparison.Ordinal);
        Assert.True(atOnce ? _wall.GetElapsedTime(begun) == TimeSpan.Zero : _wall.GetElapsedTime(begun) >= least, $"{_wall.GetElapsedTime(begun)} for {heard.Length} bytes");
    }

    public void Dispose()
    {
        _folder.Delete(recursive: true);
        _limit.Dispose();
    }

    /// <summary>The echo and the answer, up to its prompt.</summary>
    private async Task<string> AnswerAsync(SerialLink line)
    {
        var heard = new StringBuilder();
        var some = new byte[64];
        while (!heard.ToString().EndsWith(':')) heard.Append(Encoding.ASCII.GetString(some, 0, await line.ReadAsync(some, _limit.Token)));
        return heard.ToString();
    }
}
