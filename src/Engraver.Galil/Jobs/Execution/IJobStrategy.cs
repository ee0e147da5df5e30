using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>How a whole job gets into the machine: sequence by sequence from here, or as programs that run there.</summary>
internal interface IJobStrategy
{
    /// <summary>Called once, when the resident program has been started: waits until it is ready.</summary>
    ValueTask<JobStep> StartAsync();

    /// <summary>Cuts every stroke from where the machine stands and returns when it stands again with the tool off.</summary>
    ValueTask<JobStep> CutAsync();

    /// <summary>The machine was stopped in the middle and stands: counts the segments that were done by then.</summary>
    /// <param name="counter">_CSS at the standstill.</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The controller could not be asked.</exception>
    ValueTask StoppedAsync(int counter);
}

/// <summary>How one vector sequence gets into the machine: fed live, or as calls of a program in the controller.</summary>
internal interface ISequenceStrategy
{
    /// <summary>Called once, when the resident program has been started: waits until it is ready.</summary>
    ValueTask<JobStep> StartAsync();

    /// <summary>Cuts the sequence from where the machine stands and returns when it stands again. Switches the tool on when everything is ready to move.</summary>
    ValueTask<JobStep> CutAsync(VectorSequence sequence);

    /// <summary>The machine was stopped in the middle and stands: counts the segments that were done by then.</summary>
    /// <param name="counter">_CSS at the standstill.</param>
    void StoppedAt(int counter);
}
