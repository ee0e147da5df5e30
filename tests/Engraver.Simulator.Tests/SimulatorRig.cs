using System.Text;

namespace Engraver.Simulator.Tests;

/// <summary>A controller in virtual time with one client; the wall clock does not advance, so that every run is the same.</summary>
internal sealed class SimulatorRig : IAsyncDisposable
{
    private readonly Stream _stream;

    public SimulatorRig(SimulatorOptions? options = null)
    {
        Time = new StoppedTimeProvider();
        Controller = new SimulatedController((options ?? new SimulatorOptions()) with { Speed = double.PositiveInfinity, Time = Time });
        _stream = Controller.OpenConnection();
    }

    public StoppedTimeProvider Time { get; }

    public SimulatedController Controller { get; }

    public Stream Stream => _stream;

    /// <summary>Sends a line with its CR and returns the available output.</summary>
    public string Ask(string line) => SendRaw(line + "\r");

    public string SendRaw(string bytes) => Exchange(_stream, bytes);

    public static string Exchange(Stream connection, string bytes)
    {
        connection.Write(Encoding.Latin1.GetBytes(bytes));
        return ReadAvailable(connection);
    }

    public static string ReadAvailable(Stream connection)
    {
        var reply = new StringBuilder();
        var buffer = new byte[65536];
        while (true)
        {
            using var cancellation = new CancellationTokenSource();
            var reading = connection.ReadAsync(buffer, cancellation.Token).AsTask();
            if (!reading.IsCompleted) cancellation.Cancel();
            try
            {
                var count = reading.GetAwaiter().GetResult(); // after it the read no longer waits for bytes
                if (count == 0) return reply.ToString();
                reply.Append(Encoding.Latin1.GetString(buffer, 0, count));
            }
            catch (OperationCanceledException)
            {
                return reply.ToString();
            }
        }
    }

    /// <summary>Sends a command that must be accepted.</summary>
    public SimulatorRig Do(params string[] commands)
    {
        foreach (var command in commands)
        {
            var reply = Ask(command);
            Assert.True(reply.Length > 0 && reply.All(c => c == ':'), $"{command} answered {reply}: {(reply.Contains('?') ? Ask("TC1") : "")}");
        }

        return this;
    }

    /// <summary>The number that MG prints.</summary>
    public double Value(string expression)
    {
        var reply = Ask("MG " + expression);
        Assert.EndsWith("\r\n:", reply);
        return double.Parse(reply[..^3], System.Globalization.CultureInfo.InvariantCulture);
    }

    /// <summary>The code of the expected refusal of the command.</summary>
    public int Refusal(string command)
    {
        Assert.Equal("?", Ask(command));
        return int.Parse(Ask("TC")[..^3], System.Globalization.CultureInfo.InvariantCulture);
    }

    public SimulatorRig Download(string program)
    {
        Assert.Equal("", Ask("DL"));
        Assert.Equal("::", SendRaw(program.ReplaceLineEndings("\r") + "\\"));
        return this;
    }

    /// <summary>Lets controller time pass until nothing moves and no thread runs.</summary>
    public SimulatorRig RunToIdle(double seconds = 60)
    {
        Assert.True(Controller.AdvanceUntil(s => s.IsIdle, TimeSpan.FromSeconds(seconds)), "not idle in time");
        return this;
    }

    /// <summary>Lets controller time pass until nothing moves; threads may continue to run.</summary>
    public SimulatorRig RunUntilStill()
    {
        Assert.True(Controller.AdvanceUntil(s => !s.IsMoving, TimeSpan.FromSeconds(60)), "not still in time");
        return this;
    }

    public SimulatorRig Pass(double milliseconds)
    {
        Controller.Advance(TimeSpan.FromMilliseconds(milliseconds));
        return this;
    }

    /// <summary>Downloads a program, runs it from the first line in thread 0 and returns its controller time in seconds.</summary>
    public double Run(string program, double seconds = 60)
    {
        Download(program).Do("XQ");
        var start = Controller.Status.Sample;
        RunToIdle(seconds);
        return (Controller.Status.Sample - start) / 1000.0;
    }

    public async ValueTask DisposeAsync()
    {
        await _stream.DisposeAsync();
        await Controller.DisposeAsync();
    }
}
