using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>How a whole job is executed: sequence by sequence from this computer, or as programs that run in the controller.</summary>
internal interface IJobStrategy
{
    /// <summary>Called once after the resident program was started: waits until it is ready.</summary>
    ValueTask<JobStep> StartAsync();

    /// <summary>Cuts every stroke from the machine's present position and returns when it is at rest with the tool off.</summary>
    ValueTask<JobStep> CutAsync();

    /// <summary>Called when the machine was stopped in the middle and is at rest: counts the segments that were completed.</summary>
    /// <param name="counter">_CSS at the standstill.</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The controller could not be queried.</exception>
    ValueTask StoppedAsync(int counter);
}

/// <summary>How one vector sequence is executed: streamed, or as calls of a program in the controller.</summary>
internal interface ISequenceStrategy
{
    /// <summary>Called once after the resident program was started: waits until it is ready.</summary>
    ValueTask<JobStep> StartAsync();

    /// <summary>Cuts the sequence from the machine's present position and returns when it is at rest. Switches the tool on when everything is ready to
    /// move.</summary>
    ValueTask<JobStep> CutAsync(VectorSequence sequence);

    /// <summary>Called when the machine was stopped in the middle and is at rest: counts the segments that were completed.</summary>
    /// <param name="counter">_CSS at the standstill.</param>
    void StoppedAt(int counter);
}
