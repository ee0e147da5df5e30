using System.Threading.Channels;
using Engraver.Core.Languages;

namespace Engraver.Links.Recording;

/// <summary>A text file that several threads write line by line without waiting: a separate thread writes it, because the stop of the machine uses the same
/// methods.</summary>
/// <remarks>When it can no longer be written (a full disk), or its reader has stopped reading (a pager, a named pipe), the recording ends without affecting
/// anything else.</remarks>
internal sealed class LineFile
{
    /// <summary>Maximum number of lines that wait for the file: about twenty minutes of a job, about twenty megabytes.</summary>
    public const int MaxWaiting = 1 << 18;

    /// <summary>Wall time without progress after the operator's stop after which waiting for the reader ends.</summary>
    public static readonly TimeSpan FlushTimeout = TimeSpan.FromSeconds(5);

    /// <summary>Wall time between two flushes: a compressed file grows with each of them.</summary>
    public static readonly TimeSpan FlushEvery = TimeSpan.FromSeconds(1);

    private readonly Channel<string> _lines = Channel.CreateBounded<string>(new BoundedChannelOptions(MaxWaiting) { SingleReader = true });
    private readonly TimeProvider _wall;
    private readonly Task _writing;
    private readonly bool _flushes;
    private volatile string? _failure;
    private long _writtenLines;

    /// <param name="writer">Owned: closed after the last line.</param>
    /// <param name="wall">The wall clock, for the waits for the reader.</param>
    /// <param name="flushes">Whether the written lines reach the system within <see cref="FlushEvery"/>, so that the file is readable after a crash.</param>
    public LineFile(TextWriter writer, TimeProvider wall, bool flushes = false)
    {
        (_wall, _flushes) = (wall, flushes);
        _writing = Task.Factory.StartNew(() => WriteAll(writer), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
    }

    /// <summary>Why it ended early; null while all lines were written.</summary>
    public string? Failure => _failure;

    public void Write(string line)
    {
        if (_failure is null && !_lines.Writer.TryWrite(line)) Fail(Wording.Get("WireTrace.ReaderTooSlow"));
    }

    /// <summary>Writes the waiting lines and closes the file.</summary>
    /// <param name="stop">The operator's stop: from then on the reader is waited for only while it makes progress.</param>
    public async Task CloseAsync(CancellationToken stop)
    {
        _lines.Writer.TryComplete();
        try
        {
            await _writing.WaitAsync(stop).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            await AwaitProgressAsync().ConfigureAwait(false);
        }
    }

    private async Task AwaitProgressAsync()
    {
        for (var before = -1L; !_writing.IsCompleted && before != Interlocked.Read(ref _writtenLines);)
        {
            before = Interlocked.Read(ref _writtenLines);
            await Task.WhenAny(_writing, Task.Delay(FlushTimeout, _wall, CancellationToken.None)).ConfigureAwait(false);
        }

        if (!_writing.IsCompleted) Fail(Wording.Get("WireTrace.ReaderStopped"));
    }

    private void WriteAll(TextWriter writer)
    {
        try
        {
            using var owned = writer;
            for (var flushed = _wall.GetTimestamp(); AwaitLines(writer, flushed);)
            {
                while (_lines.Reader.TryRead(out var line))
                {
                    writer.WriteLine(line);
                    Interlocked.Increment(ref _writtenLines);
                }

                if (!_flushes || _wall.GetElapsedTime(flushed) < FlushEvery) continue;
                writer.Flush();
                flushed = _wall.GetTimestamp();
            }
        }
        catch (IOException unwritten)
        {
            Fail(SystemErrorText.FromException(unwritten));
        }
    }

    /// <summary>Waits for lines, and flushes the written ones when no line comes for a while.</summary>
    /// <returns>False when there are no more.</returns>
    private bool AwaitLines(TextWriter writer, long flushed)
    {
        var more = _lines.Reader.WaitToReadAsync().AsTask();
        if (!_flushes || more.IsCompleted) return more.GetAwaiter().GetResult();
        var rest = FlushEvery - _wall.GetElapsedTime(flushed);
        if (!more.Wait(rest > TimeSpan.Zero ? rest : TimeSpan.Zero)) writer.Flush(); // a separate thread that delays no other
        return more.GetAwaiter().GetResult();
    }

    private void Fail(string why) => Interlocked.CompareExchange(ref _failure, why, null);
}
