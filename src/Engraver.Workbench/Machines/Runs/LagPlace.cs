using Engraver.Core.Geometry;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>A part of the path on which a run was slower than planned.</summary>
/// <param name="Place">Where it begins, drawing millimetres.</param>
/// <param name="Entity">Drawing entity there.</param>
/// <param name="Seconds">Time that was lost.</param>
/// <param name="PlannedSpeed">Mean speed of the plan, mm/s.</param>
/// <param name="Speed">Mean speed of the run, mm/s.</param>
/// <param name="PlannedAcceleration">Mean magnitude of the change of speed in the plan, mm/s2.</param>
/// <param name="Acceleration">The same in the run, mm/s2, by positions at least a hundredth of a second apart.</param>
public readonly record struct LagPlace(Point2D Place, int Entity, double Seconds, double PlannedSpeed, double Speed, double PlannedAcceleration, double Acceleration);
