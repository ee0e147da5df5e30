using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>A segment with its heights, millimetres; only a line has two different heights.</summary>
public readonly record struct RaisedSegment(Segment Segment, double StartZ, double EndZ);
