using Engraver.Galil.Programs;

namespace Engraver.Galil.Jobs;

/// <summary>How one vector sequence gets into the machine: fed live, or as calls of a program in the controller.</summary>
internal interface ISequenceWay
{
    /// <summary>Called once, when the resident program has been started: waits until it is ready.</summary>
    ValueTask<JobStep> StartAsync();

    /// <summary>Cuts the sequence from where the machine stands and returns when it stands again. Switches the tool on when everything is ready to move.</summary>
    ValueTask<JobStep> CutAsync(VectorSequence sequence);

    /// <summary>The machine was stopped in the middle and stands: counts the segments that were done by then.</summary>
    /// <param name="counter">_CSS at the standstill.</param>
    void StoppedAt(int counter);
}
