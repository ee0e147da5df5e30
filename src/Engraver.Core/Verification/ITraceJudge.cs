namespace Engraver.Core.Verification;

/// <summary>Compares the motion of a machine with a drawing while it is reported: in plan (<see cref="TraceJudge"/>), or in three coordinates
/// (<see cref="HeightJudge"/>).</summary>
public interface ITraceJudge
{
    /// <summary>Adds a machine position; between two consecutive cutting samples the machine moved straight.</summary>
    void Add(in TraceSample sample);

    /// <summary>Adds a span that the machine moved along.</summary>
    void Add(in TraceSpan span);

    /// <summary>The next sample is the first of another run: the machine is at rest where it was found.</summary>
    void BeginRun()
    {
    }

    /// <summary>The result so far; after the last sample, the final result.</summary>
    TraceVerdict Verdict();
}
