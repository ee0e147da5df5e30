using Engraver.Core.Machines;
using Engraver.Links;
using Engraver.Links.Recording;
using Engraver.Simulator.Clocks;

namespace Engraver.Workbench.Composition;

/// <summary>The clock that a job on a machine goes by, for as long as this is held: the wall's, or that of a simulated controller which gives its
/// own.</summary>
public sealed class MachineClock : IDisposable
{
    private readonly IDisposable? _taken;
    private readonly Action? _heard;

    private MachineClock(TimeProvider time, IDisposable? taken, Action? heard) => (Time, _taken, _heard) = (time, taken, heard);

    public TimeProvider Time { get; }

    /// <summary>The system's clock, or a test's; disposing leaves it alone.</summary>
    public static MachineClock FromWall(TimeProvider wall) => new(wall, null, null);

    /// <param name="clock">Owned: it is given back with this.</param>
    public static MachineClock FromSimulator(HostClock clock) => new(clock, clock, null);

    /// <param name="clock">Owned: it is given back with this.</param>
    public static MachineClock FromOffer(OfferedClock clock)
    {
        ArgumentNullException.ThrowIfNull(clock);
        return new(clock, clock, clock.Heard);
    }

    /// <summary>Shakes hands with a machine and goes by this clock; nothing of it is kept to be replayed.</summary>
    /// <param name="trace">Where every line on the wire is written; null for nowhere.</param>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public Task<IMachineConnection> ShakeHandsAsync(MachineConnection connection, MachineTrace? trace, CancellationToken cancellation) => ShakeHandsAsync(connection, trace, conversation: null, cancellation);

    /// <summary>Shakes hands with a machine and goes by this clock.</summary>
    /// <param name="trace">Where every line on the wire is written; null for nowhere.</param>
    /// <param name="conversation">Where every byte that is said is kept, to be replayed; null for nowhere.</param>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public Task<IMachineConnection> ShakeHandsAsync(MachineConnection connection, MachineTrace? trace, MachineConversation? conversation, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(connection);
        return connection.Driver.OpenAsync(
            async stop =>
            {
                var link = Over(await connection.OpenLinkAsync(stop).ConfigureAwait(false));
                return conversation is null ? link : conversation.Recorder.Over(link);
            },
            trace?.Wire,
            Time,
            cancellation);
    }

    /// <summary>Begins a trace of every line on the wire, timed by this clock.</summary>
    /// <param name="file">Owned: it is closed with the trace.</param>
    public MachineTrace TraceTo(TextWriter file, TimeProvider wall) => new(new WireTrace(file, Time, wall: wall));

    /// <summary>Begins to keep what is said, timed by this clock.</summary>
    /// <param name="file">Owned: it is closed with the conversation.</param>
    public MachineConversation ConversationTo(TextWriter file, TimeProvider wall) => new(new ConversationRecorder(file, Time, _taken is null ? ConversationClock.Wall : ConversationClock.Controller, wall));

    public void Dispose() => _taken?.Dispose();

    private IControllerLink Over(IControllerLink link) => _heard is null ? link : new ClockedLink(link, _heard);
}

/// <summary>The record of a link: every line on the wire.</summary>
public sealed class MachineTrace
{
    internal MachineTrace(WireTrace wire) => Wire = wire;

    internal WireTrace Wire { get; }

    /// <summary>Why it ended early; null when it is whole.</summary>
    public string? Failure => Wire.Failure;

    /// <summary>Writes what is left and closes the file.</summary>
    public Task CloseAsync(CancellationToken cancellation) => Wire.CloseAsync(cancellation);
}

/// <summary>What is said to a machine, kept to be replayed.</summary>
public sealed class MachineConversation
{
    internal MachineConversation(ConversationRecorder recorder) => Recorder = recorder;

    internal ConversationRecorder Recorder { get; }

    /// <summary>Why it was not kept whole; null while it is.</summary>
    public string? Failure => Recorder.Failure;

    /// <summary>Writes what is left and closes the file.</summary>
    public Task CloseAsync(CancellationToken cancellation) => Recorder.CloseAsync(cancellation);
}
