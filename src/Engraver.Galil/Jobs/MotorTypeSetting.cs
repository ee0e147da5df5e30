using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs;

/// <summary>The motor types of the profile, set once before a job where the controller has others, in the order that the reference requires: motor off,
/// MT, motor on (galil-dmc.md C, MT; J.9). They remain set.</summary>
internal static class MotorTypeSetting
{
    /// <summary>Call at rest. A motor whose type changes may count in another register: where its position is another number afterwards the job
    /// ends.</summary>
    public static async ValueTask SetAsync(JobMachine machine)
    {
        foreach (var axis in machine.Profile.Axes.All)
        {
            if (axis.MotorType is not { } type) continue;
            var present = await machine.Commands.AskAsync($"_MT{axis.Letter}").ConfigureAwait(false);
            if (Math.Abs(present - type) >= SameType) await ChangeAsync(machine, axis.Letter, present, type).ConfigureAwait(false);
        }
    }

    /// <summary>Types differ by a half at least.</summary>
    private const double SameType = 0.1;

    private static async ValueTask ChangeAsync(JobMachine machine, char axis, double present, double type)
    {
        var before = await machine.Commands.AskAsync($"_RP{axis}").ConfigureAwait(false);
        await machine.Commands.SendAllAsync([$"MO{axis}", $"MT{axis}={DmcFormat.Number(type)}", $"SH{axis}"]).ConfigureAwait(false);
        var after = await machine.Commands.AskAsync($"_RP{axis}").ConfigureAwait(false);
        if (after == before) return;
        var name = machine.Profile.Axes.NameOf(axis);
        throw (JobEnd.Broken(Wording.Get("MotorTypeSetting.PositionChanged", name, DmcFormat.Number(present), DmcFormat.Number(type), before, after)) with { Doubt = Wording.Get("MotorTypeSetting.Doubt", name) }).ToException();
    }
}
