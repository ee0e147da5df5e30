namespace Engraver.Simulator.Motion;

/// <summary>First axis: CentreX + RadiusX cos(angle), second: CentreY + RadiusY sin(angle), counts; the angle changes from Start by the signed sweep,
/// degrees.</summary>
public readonly record struct ArcCourse(double CentreX, double CentreY, double RadiusX, double RadiusY, double StartDegrees, double SweepDegrees);
