using Engraver.Core.Machines;
using Engraver.Links;
using Engraver.Links.Recording;
using Engraver.Simulator.Clocks;

namespace Engraver.Workbench.Composition;

/// <summary>The clock of a job on a machine until disposed: the wall clock, or the clock of a simulated controller.</summary>
public sealed class MachineClock : IDisposable
{
    private readonly IDisposable? _registration;
    private readonly Action? _onReceived;

    private MachineClock(TimeProvider time, IDisposable? taken, Action? heard) => (Time, _registration, _onReceived) = (time, taken, heard);

    public TimeProvider Time { get; }

    /// <summary>The system clock or a test clock; not disposed.</summary>
    public static MachineClock FromWall(TimeProvider wall) => new(wall, null, null);

    /// <param name="clock">Owned: released with this object.</param>
    public static MachineClock FromSimulator(HostClock clock) => new(clock, clock, null);

    /// <param name="clock">Owned: released with this object.</param>
    public static MachineClock FromOffer(SharedClock clock)
    {
        ArgumentNullException.ThrowIfNull(clock);
        return new(clock, clock, clock.Invalidate);
    }

    /// <summary>Performs the handshake with a machine using this clock, without recording the conversation.</summary>
    /// <param name="trace">Receives every line on the wire; null for none.</param>
    /// <exception cref="ControllerException">The link could not be established.</exception>
    public Task<IMachineConnection> HandshakeAsync(MachineConnection connection, MachineTrace? trace, CancellationToken cancellation) => HandshakeAsync(connection, trace, conversation: null, cancellation);

    /// <summary>Performs the handshake with a machine using this clock.</summary>
    /// <param name="trace">Receives every line on the wire; null for none.</param>
    /// <param name="conversation">Records every byte for a replay; null for none.</param>
    /// <exception cref="ControllerException">The link could not be established.</exception>
    public Task<IMachineConnection> HandshakeAsync(MachineConnection connection, MachineTrace? trace, MachineConversation? conversation, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(connection);
        return connection.Driver.OpenAsync(
            async stop =>
            {
                var link = Wrap(await connection.OpenLinkAsync(stop).ConfigureAwait(false));
                return conversation is null ? link : conversation.Recorder.Record(link);
            },
            trace?.Wire,
            Time,
            cancellation);
    }

    /// <summary>Starts a trace of every line on the wire, timed by this clock.</summary>
    /// <param name="file">Owned: it is closed with the trace.</param>
    public MachineTrace TraceTo(TextWriter file, TimeProvider wall) => new(new WireTrace(file, Time, wall: wall));

    /// <summary>Starts recording the conversation, timed by this clock.</summary>
    /// <param name="file">Owned: it is closed with the conversation.</param>
    public MachineConversation ConversationTo(TextWriter file, TimeProvider wall) => new(new ConversationRecorder(file, Time, _registration is null ? ConversationClock.Wall : ConversationClock.Controller, wall));

    public void Dispose() => _registration?.Dispose();

    private IControllerLink Wrap(IControllerLink link) => _onReceived is null ? link : new ClockedLink(link, _onReceived);
}
