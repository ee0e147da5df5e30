namespace Engraver.Simulator;

/// <summary>A = CentreA + RadiusA cos(angle), B = CentreB + RadiusB sin(angle), counts; the angle goes from Start by the signed sweep, degrees.</summary>
public readonly record struct ArcCourse(double CentreA, double CentreB, double RadiusA, double RadiusB, double StartDegrees, double SweepDegrees);

/// <summary>Is told everything that goes into a record, in order of time, while the controller computes.</summary>
public interface IMotionListener
{
    /// <summary>A sample of motion, the place where a motion begins, or a change of an output.</summary>
    void Add(in MotionSample sample);

    /// <summary>Many samples of constant speed.</summary>
    void Add(MotionSpan span);
}
