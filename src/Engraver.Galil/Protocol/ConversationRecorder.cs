using Engraver.Core.Machines;
using Engraver.Galil.Links;

namespace Engraver.Galil.Protocol;

/// <summary>Keeps a conversation while it is held (<see cref="Conversation"/>). Nobody waits for its file.</summary>
public sealed class ConversationRecorder
{
    private readonly Lock _guard = new();
    private readonly LineFile _file;
    private readonly TimeProvider _time;
    private readonly long _start;
    private int _links;

    /// <param name="writer">Owned: closed at the end.</param>
    /// <param name="time">The clock of the conversation.</param>
    /// <param name="isControllersClock">Whether it is that of a simulated controller, whose times are kept as they are.</param>
    /// <param name="wall">The wall clock, for the waits at the end.</param>
    public ConversationRecorder(TextWriter writer, TimeProvider time, bool isControllersClock, TimeProvider wall)
    {
        ArgumentNullException.ThrowIfNull(time);
        (_time, _start, _file) = (time, isControllersClock ? 0 : time.GetTimestamp(), new LineFile(writer, wall, flushes: true));
        _file.Write(Conversation.Header(isControllersClock));
    }

    /// <summary>Why it was not kept whole; null while it is.</summary>
    public string? Failure => _file.Failure;

    /// <summary>The link, of which everything that is said is kept.</summary>
    public IControllerLink Over(IControllerLink link)
    {
        var number = Interlocked.Increment(ref _links) - 1;
        Add(number, ConversationAct.Opened, default);
        return new RecordedLink(link, number, this);
    }

    /// <summary>Writes what waits, with the mark of the end, and closes the file.</summary>
    /// <param name="stop">As for <see cref="WireTrace.CloseAsync"/>.</param>
    public Task CloseAsync(CancellationToken stop)
    {
        _file.Write(Conversation.End);
        return _file.CloseAsync(stop);
    }

    private void Add(int link, ConversationAct act, ReadOnlySpan<byte> bytes)
    {
        if (_file.Failure is not null) return;
        var said = bytes.ToArray();
        lock (_guard) _file.Write(new ConversationStep((long)((Int128)(_time.GetTimestamp() - _start) * TimeSpan.TicksPerSecond / _time.TimestampFrequency), link, act, said).ToString());
    }

    private sealed class RecordedLink(IControllerLink link, int number, ConversationRecorder recorder) : IControllerLink
    {
        private int _closed;

        public string Description => link.Description;

        public SerialLine? Line => link.Line;

        public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
        {
            recorder.Add(number, ConversationAct.Said, bytes.Span);
            return link.WriteAsync(bytes, cancellation);
        }

        public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => link.ReadAsync(buffer, cancellation);

        public ValueTask DisposeAsync()
        {
            if (Interlocked.Exchange(ref _closed, 1) == 0) recorder.Add(number, ConversationAct.Closed, default);
            return link.DisposeAsync();
        }
    }
}
