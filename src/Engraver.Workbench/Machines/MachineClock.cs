using Engraver.Galil.Links;
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

    /// <summary>A link for a job that goes by this clock.</summary>
    public IControllerLink Over(IControllerLink link) => _heard is null ? link : new ClockedLink(link, _heard);

    public void Dispose() => _taken?.Dispose();
}
