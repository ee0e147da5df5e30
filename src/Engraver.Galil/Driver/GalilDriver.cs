using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Operations;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Jobs.Timing;
using Engraver.Galil.Language;
using Engraver.Galil.Programs;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Terminals;

namespace Engraver.Galil.Driver;

/// <summary>The DMC family behind the machine seam; connected it is a <see cref="GalilConnection"/>.</summary>
public sealed class GalilDriver : IMachineDriver
{
    /// <summary>The name of the family in a machine profile.</summary>
    public const string FamilyKey = "galil";

    public string Key => FamilyKey;

    public string Name => "Galil DMC-21x3";

    public MachineLimits Limits => DmcLimits.Machine;

    public IReadOnlyList<ExecutionStrategy> Strategies => JobModes.Strategies;

    public ExecutionStrategy DefaultStrategy => JobModes.Strategies[0];

    public OperationSupport SupportOf(MachineProfile profile) => ProgramSupport.On(Name, profile);

    public CommandTimes NetworkTimes => DmcTimes.Ethernet;

    public string Describe(ExecutionStrategy strategy) => JobModes.Of(strategy) switch
    {
        JobMode.Stream => Wording.Get("Strategy.Stream"),
        JobMode.Calls => Wording.Get("Strategy.Calls"),
        _ => Wording.Get("Strategy.Program"),
    };

    public MotionGeneration Generate(Toolpath toolpath, MachineProfile profile, MotionTolerances tolerances, Func<int, SourceRef>? sourceOf, MotionStyle style) =>
        MotionProgramGenerator.Generate(toolpath, profile, tolerances, sourceOf, style);

    public LinkFeedFit LimitFeedToLink(MotionProgram program, ControllerAddress? address, ExecutionStrategy strategy, Func<int, SourceRef>? sourceOf) => (LineOf(address), JobModes.Of(strategy)) is ({ } line, JobMode.Stream)
        ? LinkFeedFitting.Create(program, line, sourceOf)
        : new LinkFeedFit(program, []);

    public CommandTimes LinkTimes(ControllerAddress? address, ExecutionStrategy strategy) => JobTime.Commands(LineOf(address), JobModes.Of(strategy));

    public double? LinkLoad(VectorSequence sequence, ControllerAddress? address, ExecutionStrategy strategy)
    {
        if (LineOf(address) is not { } line || JobModes.Of(strategy) != JobMode.Stream) return null;
        var (needed, carried) = LinkFeedLimit.Rates(sequence, line);
        return needed / carried;
    }

    public async Task<IMachineConnection> OpenAsync(Func<CancellationToken, Task<IControllerLink>> openLink, IWireTrace? trace, TimeProvider time, CancellationToken cancellation) =>
        await GalilConnection.OpenAsync(openLink, trace, time, cancellation).ConfigureAwait(false);

    public async Task<IMachineTerminal> OpenTerminalAsync(Func<CancellationToken, Task<IControllerLink>> openLink, TimeProvider time, CancellationToken cancellation) =>
        await MachineTerminal.OpenAsync(openLink, time, cancellation).ConfigureAwait(false);

    private static SerialLine? LineOf(ControllerAddress? address) => address is SerialAddress serial ? new SerialLine(serial.Baud) : null;
}
