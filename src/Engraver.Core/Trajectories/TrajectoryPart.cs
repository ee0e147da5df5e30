using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>A part of the executed curve.</summary>
/// <param name="Deviation">Deviation in its middle, millimetres.</param>
public readonly record struct TrajectoryPart(Segment Curve, double Deviation);
