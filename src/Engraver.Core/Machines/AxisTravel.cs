namespace Engraver.Core.Machines;

/// <summary>The ends of an axis' travel, machine mm from the controller's own zero; both may be reached.</summary>
public sealed record AxisTravel(double Min, double Max);
