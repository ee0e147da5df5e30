using Engraver.Galil.Links;
using Engraver.Galil.Sessions;
using Engraver.Simulator.Clocks;

namespace Engraver.Workbench.Machines;

/// <summary>The clock that a job on a machine goes by, for as long as this is held: the wall's, or that of a simulated controller which gives its own.</summary>
public sealed class MachineClock : IDisposable
{
    private readonly IDisposable? _taken;
    private readonly Action? _heard;

    private MachineClock(TimeProvider time, IDisposable? taken, Action? heard) => (Time, _taken, _heard) = (time, taken, heard);

    public TimeProvider Time { get; }

    /// <summary>A clock that nobody has to give back.</summary>
    public static MachineClock FromWall(TimeProvider wall) => new(wall, null, null);

    /// <param name="clock">Owned: it is given back with this.</param>
    public static MachineClock FromSimulator(HostClock clock) => new(clock, clock, null);

    /// <param name="clock">Owned: it is given back with this.</param>
    public static MachineClock FromOffer(OfferedClock clock)
    {
        ArgumentNullException.ThrowIfNull(clock);
        return new(clock, clock, clock.Heard);
    }

    /// <summary>A session that goes by this clock.</summary>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public Task<ControllerSession> OpenSessionAsync(MachineConnection connection, SessionOptions options, CancellationToken cancellation) =>
        ControllerSession.OpenAsync(async stop => Over(await connection.OpenLinkAsync(stop).ConfigureAwait(false)), options, Time, cancellation);

    public void Dispose() => _taken?.Dispose();

    private IControllerLink Over(IControllerLink link) => _heard is null ? link : new ClockedLink(link, _heard);
}
