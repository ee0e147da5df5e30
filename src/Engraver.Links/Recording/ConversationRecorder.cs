using Engraver.Core.Machines;

namespace Engraver.Links.Recording;

/// <summary>Records the conversation of a session (<see cref="Conversation"/>). Writing its file never delays the session.</summary>
public sealed class ConversationRecorder
{
    private readonly Lock _guard = new();
    private readonly LineFile _file;
    private readonly TimeProvider _time;
    private readonly long _start;
    private int _links;

    /// <param name="writer">Owned: closed at the end.</param>
    /// <param name="time">The clock of the recording.</param>
    /// <param name="kind">The kind of that clock: times of a simulated controller are stored as they are; times reported by a link are stored as
    /// reported.</param>
    /// <param name="wall">The wall clock, for the waits at the end.</param>
    public ConversationRecorder(TextWriter writer, TimeProvider time, ConversationClock kind, TimeProvider wall)
    {
        ArgumentNullException.ThrowIfNull(time);
        (_time, _start, _file) = (time, kind == ConversationClock.Controller ? 0 : time.GetTimestamp(), new LineFile(writer, wall, flushes: true));
        _file.Write(Conversation.Header(kind));
    }

    /// <summary>Why the recording is incomplete; null while it is complete.</summary>
    public string? Failure => _file.Failure;

    /// <summary>A link that records everything that is sent over the given one.</summary>
    public IControllerLink Record(IControllerLink link)
    {
        var number = Interlocked.Increment(ref _links) - 1;
        Add(number, ConversationEvent.Opened, default, link.NowTicks);
        return new RecordedLink(link, number, this);
    }

    /// <summary>Writes the waiting steps and the end mark, and closes the file.</summary>
    /// <param name="stop">As for <see cref="WireTrace.CloseAsync"/>.</param>
    public Task CloseAsync(CancellationToken stop)
    {
        _file.Write(Conversation.End);
        return _file.CloseAsync(stop);
    }

    private void Add(int link, ConversationEvent kind, ReadOnlySpan<byte> bytes, long? ticks)
    {
        if (_file.Failure is not null) return;
        var said = bytes.ToArray();
        lock (_guard) _file.Write(new ConversationStep(ticks ?? (long)((Int128)(_time.GetTimestamp() - _start) * TimeSpan.TicksPerSecond / _time.TimestampFrequency), link, kind, said).ToString());
    }

    private sealed class RecordedLink(IControllerLink link, int number, ConversationRecorder recorder) : IControllerLink
    {
        private int _closed;

        public string Description => link.Description;

        public SerialLine? Line => link.Line;

        /// <summary>Another thread may let time pass before the bytes are received: if the controller reports when it received them, this is the time of the
        /// step.</summary>
        public async ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
        {
            var isTold = link.NowTicks is not null;
            if (!isTold) recorder.Add(number, ConversationEvent.Said, bytes.Span, ticks: null);
            await link.WriteAsync(bytes, cancellation).ConfigureAwait(false);
            if (isTold) recorder.Add(number, ConversationEvent.Said, bytes.Span, link.ReceivedTicks);
        }

        public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => link.ReadAsync(buffer, cancellation);

        public ValueTask DisposeAsync()
        {
            if (Interlocked.Exchange(ref _closed, 1) == 0) recorder.Add(number, ConversationEvent.Closed, default, link.NowTicks);
            return link.DisposeAsync();
        }
    }
}
