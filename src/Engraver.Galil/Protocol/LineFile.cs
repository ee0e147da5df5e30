using System.Threading.Channels;
using Engraver.Core.Languages;

namespace Engraver.Galil.Protocol;

/// <summary>A text that several threads write line by line and that none of them waits for: a thread of its own writes it, because the stop of the machine goes by the same ways.</summary>
/// <remarks>When it cannot be written any more (a full disk), or its reader has stopped reading (a pager, a named pipe), it ends and nothing else is disturbed.</remarks>
internal sealed class LineFile
{
    /// <summary>Most lines that wait for the file: some twenty minutes of a job, some twenty megabytes.</summary>
    public const int MostWaiting = 1 << 18;

    /// <summary>After the operator's stop: wall time without progress after which the reader is given up.</summary>
    public static readonly TimeSpan Patience = TimeSpan.FromSeconds(5);

    private readonly Channel<string> _lines = Channel.CreateBounded<string>(new BoundedChannelOptions(MostWaiting) { SingleReader = true });
    private readonly TimeProvider _wall;
    private readonly Task _writing;
    private readonly bool _flushes;
    private volatile string? _failure;
    private long _taken;

    /// <param name="writer">Owned: closed after the last line.</param>
    /// <param name="wall">The wall clock, for the waits for the reader.</param>
    /// <param name="flushes">Whether what is written reaches the system whenever no line waits, so that a crash leaves it readable.</param>
    public LineFile(TextWriter writer, TimeProvider wall, bool flushes = false)
    {
        (_wall, _flushes) = (wall, flushes);
        _writing = Task.Factory.StartNew(() => WriteAll(writer), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
    }

    /// <summary>Why it ended early; null while all of it was written.</summary>
    public string? Failure => _failure;

    public void Write(string line)
    {
        if (_failure is null && !_lines.Writer.TryWrite(line)) Fail(Wording.Get("WireTrace.WhoeverReadsDoesNot"));
    }

    /// <summary>Writes the lines that wait and closes the file.</summary>
    /// <param name="stop">The operator's stop: from then on the reader is waited for only while it takes something.</param>
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
                if (_flushes && !_lines.Reader.TryPeek(out _)) writer.Flush();
            }
        }
        catch (IOException unwritten)
        {
            Fail(SystemReason.Of(unwritten));
        }
    }

    private void Fail(string why) => Interlocked.CompareExchange(ref _failure, why, null);
}
