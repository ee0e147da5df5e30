namespace Engraver.Simulator;

/// <summary>Receives all entries of a record, in order of time, while the controller computes them.</summary>
public interface IMotionListener
{
    /// <summary>Called for a sample of motion, the start position of a motion, or a change of an output.</summary>
    void Add(in MotionSample sample);

    /// <summary>Called for a span of many samples at constant speed.</summary>
    void Add(MotionSpan span);
}
