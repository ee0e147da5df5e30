using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Motion;

/// <summary>A family of controllers before one of them is connected: the limits of a machine, the conversion of a toolpath to motion, and its duration. A
/// connected controller is an <see cref="IMachineConnection"/> (ADR 9).</summary>
public interface IMachineDriver : IControllerFamily
{
    /// <summary>The ways in which a job is run, in the order in which they are offered.</summary>
    IReadOnlyList<ExecutionStrategy> Strategies { get; }

    /// <summary>The strategy of a job for which none is selected.</summary>
    ExecutionStrategy DefaultStrategy { get; }

    /// <summary>What its controllers can do of operations on a machine.</summary>
    OperationSupport SupportOf(MachineProfile profile) => new(Name);

    /// <summary>The times of a job that the host runs over a network: planned times and the playback show them while no other link is selected.</summary>
    CommandTimes NetworkTimes { get; }

    /// <summary>What a strategy does, for help: part of a sentence, without a full stop.</summary>
    string Describe(ExecutionStrategy strategy);

    /// <summary>Converts a toolpath in millimetres to a motion program in counts.</summary>
    /// <param name="tolerances">How far the motion may be beside the toolpath.</param>
    /// <param name="sourceOf">Position of an entity in the drawing; diagnostics name it.</param>
    MotionGeneration Generate(Toolpath toolpath, MachineProfile profile, MotionTolerances tolerances, Func<int, SourceRef>? sourceOf, MotionStyle style);

    /// <summary>The program as it will be run over this link: where the link is too slow for its feed it is cut more slowly, and the finding reports
    /// it.</summary>
    /// <param name="address">Null for none: the feed is not limited.</param>
    LinkFeedFit LimitFeedToLink(MotionProgram program, ControllerAddress? address, ExecutionStrategy strategy, Func<int, SourceRef>? sourceOf);

    /// <summary>The times of a job that is run over this link.</summary>
    /// <param name="address">Null for none: as over a network.</param>
    CommandTimes LinkTimes(ControllerAddress? address, ExecutionStrategy strategy);

    /// <summary>The largest part of its time in which a link must transmit the commands of a sequence at its speed, 0 to 1, more if it is too slow; null if the
    /// link has no such limit.</summary>
    /// <param name="address">Null for none.</param>
    double? LinkLoad(VectorSequence sequence, ControllerAddress? address, ExecutionStrategy strategy);

    /// <summary>Identifies the controller at the other end of a link. The driver opens no link itself.</summary>
    /// <param name="openLink">Opens one more link to the same controller.</param>
    /// <param name="trace">Receives every line on the wire; null for none.</param>
    /// <exception cref="ControllerException">No answer, or not a controller of the family.</exception>
    Task<IMachineConnection> OpenAsync(Func<CancellationToken, Task<IControllerLink>> openLink, IWireTrace? trace, TimeProvider time, CancellationToken cancellation);

    /// <summary>Opens a conversation in the controller's own language.</summary>
    /// <param name="openLink">As for <see cref="OpenAsync"/>.</param>
    /// <exception cref="ControllerException">As for <see cref="OpenAsync"/>.</exception>
    Task<IMachineTerminal> OpenTerminalAsync(Func<CancellationToken, Task<IControllerLink>> openLink, TimeProvider time, CancellationToken cancellation);
}
