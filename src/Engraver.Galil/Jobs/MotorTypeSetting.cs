using Engraver.Core.Machines;
using Engraver.Galil.Language;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs;

/// <summary>The motor types of the profile, set once before a job where the controller holds others, in the order that the reference demands: motor off,
/// MT, motor on (galil-dmc.md C, MT; J.9). They stay set.</summary>
internal static class MotorTypeSetting
{
    /// <summary>Call at rest. A motor whose type changes may count from another register: where its position reads another number afterwards the job
    /// ends.</summary>
    public static async ValueTask<JobStep> SetAsync(JobMachine machine)
    {
        foreach (var axis in machine.Profile.Axes.All)
        {
            if (axis.MotorType is not { } type) continue;
            var (held, end) = await machine.AskAsync($"_MT{axis.Letter}").ConfigureAwait(false);
            if (end.Ends) return end;
            if (Math.Abs(held - type) < SameType) continue;
            if (await ChangeAsync(machine, axis.Letter, held, type).ConfigureAwait(false) is { Ends: true } failed) return failed;
        }

        return JobStep.Done;
    }

    /// <summary>Types differ by a half at least.</summary>
    private const double SameType = 0.1;

    private static async ValueTask<JobStep> ChangeAsync(JobMachine machine, char axis, double held, double type)
    {
        var (before, end) = await machine.AskAsync($"_RP{axis}").ConfigureAwait(false);
        if (end.Ends) return end;
        if (await machine.SendAllAsync([$"MO{axis}", $"MT{axis}={DmcFormat.Number(type)}", $"SH{axis}"]).ConfigureAwait(false) is { Ends: true } refused) return refused;
        var (after, broken) = await machine.AskAsync($"_RP{axis}").ConfigureAwait(false);
        if (broken.Ends) return broken;
        return after == before ? JobStep.Done : JobStep.Broken(Wording.Get("MotorTypeSetting.PositionChanged", machine.Profile.Axes.NameOf(axis), DmcFormat.Number(held), DmcFormat.Number(type), before, after)) with { Doubt = Wording.Get("MotorTypeSetting.Doubt", machine.Profile.Axes.NameOf(axis)) };
    }
}
