namespace Engraver.Workbench.Machines;

/// <summary>The clock that a job on a machine goes by, for as long as this is held: the wall's, or that of a simulated controller which gives its own.</summary>
public sealed class MachineClock : IDisposable
{
    private readonly IDisposable? _taken;

    private MachineClock(TimeProvider time, IDisposable? taken) => (Time, _taken) = (time, taken);

    public TimeProvider Time { get; }

    /// <summary>A clock that nobody has to give back.</summary>
    public static MachineClock FromWall(TimeProvider wall) => new(wall, null);

    /// <param name="taken">Disposing it gives the clock back.</param>
    public static MachineClock FromController<TClock>(TClock taken)
        where TClock : TimeProvider, IDisposable => new(taken, taken);

    public void Dispose() => _taken?.Dispose();
}
