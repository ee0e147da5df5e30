using Engraver.Core.Machines;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using Variables = Engraver.Galil.Programs.Resident.ResidentProgram.Variables;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Homing: the program in the controller (<see cref="HomingProgram"/>) is started and watched, one axis after the other, each with its
/// time-out.</summary>
internal sealed class HomingMove(JobMachine machine) : IJobStrategy
{
    /// <summary>_MT of a stepper is 2, -2, 2.5 or -2.5 (galil-dmc.md C).</summary>
    private const double Stepper = 2.0;

    private readonly IReadOnlyList<MachineAxis> _axes = HomingProgram.Axes(machine.Profile);

    /// <summary>What was added to the counts of each axis, in the order of the machine's axes; null unless every axis is homed.</summary>
    public IReadOnlyList<int>? Shift { get; private set; }

    public Phase Whole => Phase.Idle;

    /// <summary>An index pulse comes from an encoder, which a stepper need not have.</summary>
    public async ValueTask StartAsync()
    {
        foreach (var axis in _axes.Where(axis => axis.Homing!.HasIndex))
        {
            if (Math.Abs(await machine.Commands.AskAsync($"_MT{axis.Letter}").ConfigureAwait(false)) >= Stepper) throw JobEnd.Broken(Wording.Get("HomingMove.StepperIndex", Name(axis))).ToException();
        }
    }

    public async ValueTask CutAsync()
    {
        if (_axes.Count == 0) throw JobEnd.Broken(Wording.Get("HomingMove.NotConfigured")).ToException();
        await machine.AwaitAsync(Variables.Go, value => value == 0).ConfigureAwait(false);
        await machine.Commands.SendAsync(ResidentServer.GoCommand).ConfigureAwait(false);
        var (under, begun) = (0, machine.Seconds);
        while (true)
        {
            await machine.PollAsync().ConfigureAwait(false);
            var values = await machine.Commands.AskAllAsync($"{HomingProgram.Done},{HomingProgram.Fault},{HomingProgram.Axis}").ConfigureAwait(false);
            if (values[0] != 0) break;
            if (values[1] != 0) throw (await FaultAsync((HomingFault)(int)values[1], _axes[(int)values[2]]).ConfigureAwait(false)).ToException();
            if (under != (int)values[2]) (under, begun) = ((int)values[2], machine.Seconds);
            if (machine.Seconds - begun > _axes[under].Homing!.Seconds) throw JobEnd.Broken(Wording.Get("HomingMove.TimeOut", Name(_axes[under]), _axes[under].Homing!.Seconds, Mark(_axes[under]))).ToException();
            await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
        }

        await ReadShiftAsync().ConfigureAwait(false);
    }

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;

    private async ValueTask ReadShiftAsync()
    {
        var values = await machine.Commands.AskAllAsync(string.Join(',', _axes.Select((_, place) => HomingProgram.Shift(place)))).ConfigureAwait(false);
        Shift = [.. machine.Profile.Axes.All.Select(axis => _axes.ToList().FindIndex(homed => homed.Letter == axis.Letter) is >= 0 and var place ? (int)values[place] : 0)];
        await machine.PollAsync().ConfigureAwait(false);
    }

    private async ValueTask<JobEnd> FaultAsync(HomingFault fault, MachineAxis axis)
    {
        var why = StopCodes.Text((int)await machine.Commands.AskAsync($"_SC{axis.Letter}").ConfigureAwait(false));
        return JobEnd.Broken(fault switch
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
