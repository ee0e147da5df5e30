using Engraver.Core.Machines;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using Variables = Engraver.Galil.Programs.Resident.ResidentProgram.Variables;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Homing: the program in the controller (<see cref="HomingProgram"/>) is told to go and is watched, one axis after the other, each with its
/// time.</summary>
internal sealed class HomingMove(JobMachine machine) : IJobStrategy
{
    /// <summary>_MT of a stepper is 2, -2, 2.5 or -2.5 (galil-dmc.md C).</summary>
    private const double Stepper = 2.0;

    private readonly IReadOnlyList<MachineAxis> _axes = HomingProgram.Axes(machine.Profile);

    /// <summary>What was added to the counts of each axis, in the order of the machine's axes; null unless every axis is homed.</summary>
    public IReadOnlyList<int>? Shift { get; private set; }

    /// <summary>An index pulse is the encoder's, which a stepper does not need to have.</summary>
    public async ValueTask<JobStep> StartAsync()
    {
        foreach (var axis in _axes.Where(axis => axis.Homing!.HasIndex))
        {
            var (type, end) = await machine.AskAsync($"_MT{axis.Letter}").ConfigureAwait(false);
            if (end.Ends) return end;
            if (Math.Abs(type) >= Stepper) return JobStep.Broken(Wording.Get("HomingMove.StepperIndex", Name(axis)));
        }

        return JobStep.Done;
    }

    public async ValueTask<JobStep> CutAsync()
    {
        if (_axes.Count == 0) return JobStep.Broken(Wording.Get("HomingMove.NotConfigured"));
        if (await machine.AwaitAsync(Variables.Go, value => value == 0).ConfigureAwait(false) is { Ends: true } unready) return unready;
        if (await machine.SendAsync(ResidentServer.GoCommand).ConfigureAwait(false) is { Ends: true } refused) return refused;
        var (under, begun) = (0, machine.Seconds);
        while (true)
        {
            if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
            var (values, lost) = await machine.AskAllAsync($"{HomingProgram.Done},{HomingProgram.Fault},{HomingProgram.Axis}").ConfigureAwait(false);
            if (lost.Ends) return lost;
            if (values[0] != 0) return await ShiftAsync().ConfigureAwait(false);
            if (values[1] != 0) return await FaultAsync((HomingFault)(int)values[1], _axes[(int)values[2]]).ConfigureAwait(false);
            if (under != (int)values[2]) (under, begun) = ((int)values[2], machine.Seconds);
            if (machine.Seconds - begun > _axes[under].Homing!.Seconds) return JobStep.Broken(Wording.Get("HomingMove.TimeOut", Name(_axes[under]), _axes[under].Homing!.Seconds, Mark(_axes[under])));
            await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
        }
    }

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;

    private async ValueTask<JobStep> ShiftAsync()
    {
        var (values, end) = await machine.AskAllAsync(string.Join(',', _axes.Select((_, place) => HomingProgram.Shift(place)))).ConfigureAwait(false);
        if (end.Ends) return end;
        Shift = [.. machine.Profile.Axes.All.Select(axis => _axes.ToList().FindIndex(homed => homed.Letter == axis.Letter) is >= 0 and var place ? (int)values[place] : 0)];
        return await machine.PollAsync().ConfigureAwait(false);
    }

    private async ValueTask<JobStep> FaultAsync(HomingFault fault, MachineAxis axis)
    {
        var (code, end) = await machine.AskAsync($"_SC{axis.Letter}").ConfigureAwait(false);
        if (end.Ends) return end;
        var why = StopCodes.Text((int)code);
        return JobStep.Broken(fault switch
        {
            HomingFault.NotLeft => Wording.Get("HomingMove.NotLeft", Name(axis), Mark(axis), why),
            HomingFault.NotFound => Wording.Get("HomingMove.NotFound", Name(axis), Mark(axis), why),
            HomingFault.Passed => Wording.Get("HomingMove.Passed", Name(axis), Mark(axis)),
            HomingFault.NoEdge => Wording.Get("HomingMove.NoEdge", Name(axis), Mark(axis), why),
            HomingFault.NoIndex => Wording.Get("HomingMove.NoIndex", Name(axis), why),
            _ => Wording.Get("HomingMove.NoBackOff", Name(axis), why),
        });
    }

    private char Name(MachineAxis axis) => machine.Profile.Axes.NameOf(axis.Letter);

    private static string Mark(MachineAxis axis) => Wording.Get(axis.Homing! switch { { HasSwitch: false } => "HomingMove.Index", { ByLimit: true } => "HomingMove.Limit", _ => "HomingMove.Switch" });
}
