namespace Engraver.Simulator;

/// <summary>A = CentreA + RadiusA cos(angle), B = CentreB + RadiusB sin(angle), counts; the angle goes from Start by the signed sweep, degrees.</summary>
public readonly record struct ArcCourse(double CentreA, double CentreB, double RadiusA, double RadiusB, double StartDegrees, double SweepDegrees);
