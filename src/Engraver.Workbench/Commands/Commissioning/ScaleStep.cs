using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>Counts per millimetre of each axis, from a measured move.</summary>
internal sealed class ScaleStep : ICommissioningStep
{
    /// <summary>Default test distance of X and Y, and of Z, which may be near the table; mm.</summary>
    private const double DefaultTravel = 10.0;
    private const double DefaultTravelZ = 1.0;

    public string Name => Wording.Get("Commission.ScaleStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        await machine.Moves.AskSpeedAsync().ConfigureAwait(false);
        var isMeasured = true;
        foreach (var letter in machine.Profile.Axes.Letters) isMeasured &= await AxisAsync(machine, letter, cancellation).ConfigureAwait(false);
        return isMeasured;
    }

    /// <returns>False if it did not move.</returns>
    private static async Task<bool> AxisAsync(CommissionedMachine machine, char letter, CancellationToken cancellation)
    {
        var axis = ProfileAxis.Of(machine.Profile, letter);
        var usual = Math.Clamp(Math.Round(axis.Scale.CountsOf(letter == machine.Profile.Axes.Z?.Letter ? DefaultTravelZ : DefaultTravel)), 1.0, 1e7);
        var prompt = new NumberPrompt(Wording.Get("Commission.EnterCountsToMeasure", letter)) { Min = 1.0, Max = 1e7, IsInteger = true, Default = NumberPrompt.Format(usual) };
        var counts = (int)await machine.Context.ValueAsync(prompt).ConfigureAwait(false);
        if (!await machine.Moves.MoveAsync(letter, counts, cancellation).ConfigureAwait(false)) return false;
        if (await machine.Context.AskAsync(new NumberPrompt(Wording.Get("Commission.EnterMeasuredDistance", letter)) { Min = 0.001, Max = 1e5, EnterEnds = true }).ConfigureAwait(false) is Answer<double>.Value { Result: var millimetres })
            Apply(machine, axis with { CountsPerMillimetre = axis.Scale.Measured(counts, millimetres).CountsPerMillimetre });
        await machine.Moves.MoveAsync(letter, -counts, cancellation).ConfigureAwait(false);
        return true;
    }

    private static void Apply(CommissionedMachine machine, MachineAxis axis)
    {
        var next = ProfileAxis.With(machine.Profile, axis);
        if (MachineProfileValidation.Check(next, MachineFamilies.DriverOf(next).Limits) is [{ } finding, ..])
        {
            machine.Context.WriteMessage(SettingWording.AtCommandLine(finding).Message, MessageKind.Warning);
            return;
        }

        machine.Context.WriteMessage(Wording.Get("Commission.ScaleSet", axis.Letter, axis.CountsPerMillimetre, ProfileAxis.Of(machine.Profile, axis.Letter).CountsPerMillimetre), MessageKind.Result);
        machine.Profile = next;
    }
}
