using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>How a whole job is executed: sequence by sequence from this computer, or as programs that run in the controller. A method that cannot continue
/// throws the end of the job (<see cref="JobEnd"/>).</summary>
internal interface IJobStrategy
{
    /// <summary>The phase of the whole job, in which the strategy enters others.</summary>
    Phase Whole { get; }

    /// <summary>Called once after the resident program was started: waits until it is ready.</summary>
    ValueTask StartAsync();

    /// <summary>Cuts every stroke from the machine's present position and returns when it is at rest with the tool off.</summary>
    ValueTask CutAsync();

    /// <summary>Called when the machine was stopped in the middle and is at rest: counts the segments that were completed.</summary>
    /// <param name="counter">_CSS at standstill.</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The controller could not be queried.</exception>
    ValueTask StoppedAsync(int counter);
}

/// <summary>How one vector sequence is executed: streamed, or as calls of a program in the controller.</summary>
internal interface ISequenceStrategy
{
    /// <summary>As <see cref="IJobStrategy.Whole"/>.</summary>
    Phase Whole { get; }

    /// <summary>Called once after the resident program was started: waits until it is ready.</summary>
    ValueTask StartAsync();

    /// <summary>Cuts the sequence from the machine's present position and returns when it is at rest. Switches the tool on when everything is ready to
    /// move.</summary>
    ValueTask CutAsync(VectorSequence sequence);

    /// <summary>Called when the machine was stopped in the middle and is at rest: counts the segments that were completed.</summary>
    /// <param name="counter">_CSS at standstill.</param>
    void StoppedAt(int counter);
}
