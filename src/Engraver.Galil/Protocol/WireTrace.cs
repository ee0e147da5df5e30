using System.Globalization;
using System.Threading.Channels;

namespace Engraver.Galil.Protocol;

/// <summary>Every line sent and every reply received, with the time, for <c>--trace</c>. Several channels may write into one trace.</summary>
/// <remarks>A line is: seconds since the trace began, the handle's name, <c>&gt;</c> sent or <c>&lt;</c> received or <c>!</c> unsolicited, the text.
/// A thread of the trace's own writes the lines, because the stop of the machine goes over the same channels. When the trace cannot be written any more (a full disk), or
/// its reader has stopped reading (a pager, a named pipe), the trace ends and nothing else is disturbed.</remarks>
public sealed class WireTrace
{
    /// <summary>Most lines that wait for the file: some twenty minutes of a job, some twenty megabytes.</summary>
    internal const int MostWaiting = 1 << 18;

    /// <summary>After the operator's stop: wall time without progress after which the trace's reader is given up.</summary>
    internal static readonly TimeSpan Patience = TimeSpan.FromSeconds(5);

    private readonly Channel<string> _lines = Channel.CreateBounded<string>(new BoundedChannelOptions(MostWaiting) { SingleReader = true });
    private readonly TimeProvider _time;
    private readonly TimeProvider _wall;
    private readonly long _start;
    private readonly Task _writing;
    private volatile string? _failure;
    private long _taken;

    /// <param name="writer">Owned: closed after the last line.</param>
    /// <param name="time">The clock of the conversation, for the times in the lines.</param>
    /// <param name="wall">The wall clock, for the waits for the trace's reader; null when both are the same.</param>
    public WireTrace(TextWriter writer, TimeProvider time, TimeProvider? wall = null)
    {
        ArgumentNullException.ThrowIfNull(time);
        (_time, _wall, _start) = (time, wall ?? time, time.GetTimestamp());
        _writing = Task.Factory.StartNew(() => WriteAll(writer), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
    }

    /// <summary>Why the trace ended early; null while all of it was written.</summary>
    public string? Failure => _failure;

    /// <summary>Writes the lines that wait and closes the file.</summary>
    /// <param name="stop">The operator's stop: from then on the trace's reader is waited for only while it takes something.</param>
    public async Task CloseAsync(CancellationToken stop)
    {
        _lines.Writer.TryComplete();
        try
        {
            await _writing.WaitAsync(stop).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            await WhileTakenAsync().ConfigureAwait(false);
        }
    }

    internal void Write(string handle, char direction, string text)
    {
        if (_failure is not null) return;
        var seconds = _time.GetElapsedTime(_start).TotalSeconds.ToString("0.000000", CultureInfo.InvariantCulture);
        var visible = text.Replace("\r", "", StringComparison.Ordinal).Replace("\n", " | ", StringComparison.Ordinal).Replace("\x12\x16", "^R^V", StringComparison.Ordinal);
        if (!_lines.Writer.TryWrite($"{seconds} {handle} {direction} {visible}")) Fail(Wording.Get("WireTrace.WhoeverReadsDoesNot"));
    }

    private async Task WhileTakenAsync()
    {
        for (var before = -1L; !_writing.IsCompleted && before != Interlocked.Read(ref _taken);)
        {
            before = Interlocked.Read(ref _taken);
            await Task.WhenAny(_writing, Task.Delay(Patience, _wall, CancellationToken.None)).ConfigureAwait(false);
        }

        if (!_writing.IsCompleted) Fail(Wording.Get("WireTrace.WhoeverReadsHasStopped"));
    }

    private void WriteAll(TextWriter writer)
    {
        try
        {
            using var owned = writer;
            foreach (var line in _lines.Reader.ReadAllAsync().ToBlockingEnumerable())
            {
                writer.WriteLine(line);
                Interlocked.Increment(ref _taken);
            }
        }
        catch (IOException unwritten)
        {
            Fail(unwritten.Message);
        }
    }

    private void Fail(string why) => Interlocked.CompareExchange(ref _failure, why, null);
}
