using System.Globalization;
using System.Text;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Programs;

/// <summary>A simulated controller with one client that sends text, in virtual time and with a wall clock that does not advance: every run is the
/// same.</summary>
internal sealed class ControllerBench : IAsyncDisposable
{
    private readonly SimulatedController _controller = new(new SimulatorOptions { Speed = double.PositiveInfinity, Time = new ManualTimeProvider(), ProgramLines = 1000 });
    private readonly Stream _stream;

    private readonly StringBuilder _received = new();

    /// <summary>All output so far, messages without their eighth bit.</summary>
    public string Received => _received.Append(string.Concat(Read().Select(letter => (char)(letter & 0x7F)))).ToString();

    public ControllerBench() => _stream = _controller.OpenConnection();

    public SimulatedController Controller => _controller;

    public ControllerStatus Status => _controller.Status;

    public IReadOnlyList<MotionSample> Record => _controller.Record.Snapshot();

    /// <summary>Sends bytes and returns the available output.</summary>
    public string Send(string bytes)
    {
        _stream.Write(Encoding.Latin1.GetBytes(bytes));
        var reply = Read();
        _received.Append(string.Concat(reply.Select(letter => (char)(letter & 0x7F))));
        return reply;
    }

    private string Read()
    {
        var reply = new StringBuilder();
        var buffer = new byte[4096];
        while (true)
        {
            using var giveUp = new CancellationTokenSource();
            var reading = _stream.ReadAsync(buffer, giveUp.Token);
            if (!reading.IsCompleted)
            {
                giveUp.Cancel();
                return reply.ToString();
            }

            reply.Append(Encoding.Latin1.GetString(buffer, 0, reading.Result));
        }
    }

    /// <summary>Sends a command that must be accepted.</summary>
    public void Do(string command)
    {
        var prompts = Printable(Send(command + "\r"));
        Assert.True(prompts.Length > 0 && prompts.All(c => c == ':'), $"{command} was answered {prompts}");
    }

    public void Download(string program)
    {
        Assert.Equal(string.Empty, Printable(Send("DL\r")));
        Assert.Equal("::", Printable(Send(program.Replace('\n', '\r') + "\\")));
    }

    /// <summary>Downloads a program and runs it from #JOB until nothing moves and no thread runs.</summary>
    public void RunJob(string program)
    {
        Download(program);
        Do("XQ#JOB");
        Assert.True(_controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromHours(1)), "The job did not end.");
    }

    public double Value(string expression)
    {
        var reply = Printable(Send($"MG {expression}\r"));
        return double.Parse(reply.TrimEnd(':'), CultureInfo.InvariantCulture);
    }

    public void Pass(double milliseconds) => _controller.Advance(TimeSpan.FromMilliseconds(milliseconds));

    public bool PassUntil(Func<ControllerStatus, bool> condition, double seconds) => _controller.AdvanceUntil(condition, TimeSpan.FromSeconds(seconds));

    public async ValueTask DisposeAsync()
    {
        await _stream.DisposeAsync();
        await _controller.DisposeAsync();
    }

    /// <summary>Without unsolicited text, whose bytes have bit 7 set (galil-dmc.md A.5).</summary>
    private static string Printable(string reply) => string.Concat(reply.Where(c => c < 128)).Trim();
}
