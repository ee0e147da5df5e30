using Engraver.Core.Machines.Setup;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>Sets the active level of limit and home switches, tested by reading their inputs.</summary>
internal sealed class SwitchStep : ICommissioningStep
{
    private static readonly IReadOnlyList<Keyword> s_levels = Keyword.List("Low", "High", "reAd");

    public string Name => Wording.Get("Commission.SwitchStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        var facts = await machine.ReadAsync(cancellation).ConfigureAwait(false);
        if (facts.LimitSense is { } limits) await OneAsync(machine, Wording.Get("Commission.LimitSwitches"), limits, sense => new SetupValue.LimitSense(sense), cancellation).ConfigureAwait(false);
        if (facts.HomeSense is { } home) await OneAsync(machine, Wording.Get("Commission.HomeSwitches"), home, sense => new SetupValue.HomeSense(sense), cancellation).ConfigureAwait(false);
        return true;
    }

    private static async Task OneAsync(CommissionedMachine machine, string switches, SwitchSense found, Func<SwitchSense, SetupValue> value, CancellationToken cancellation)
    {
        await WriteInputsAsync(machine, cancellation).ConfigureAwait(false);
        string answer;
        while ((answer = await machine.Context.ChoiceAsync(Wording.Get("Commission.EnterActiveLevel", switches), s_levels, found.ToString()).ConfigureAwait(false)) == "reAd") await WriteInputsAsync(machine, cancellation).ConfigureAwait(false);
        var sense = Enum.Parse<SwitchSense>(answer);
        if (sense == found || !await machine.TryAsync(value(sense), cancellation).ConfigureAwait(false)) return;
        var isAccepted = false;
        try
        {
            await WriteInputsAsync(machine, cancellation).ConfigureAwait(false);
            isAccepted = await machine.Context.ConfirmAsync(Wording.Get("Commission.ConfirmSwitches")).ConfigureAwait(false);
        }
        finally
        {
            if (!isAccepted) await machine.TryAsync(value(found), CancellationToken.None).ConfigureAwait(false);
        }

        if (isAccepted) machine.Accepted(value(sense), Wording.Get(sense == SwitchSense.Low ? "Commission.SwitchesLow" : "Commission.SwitchesHigh", switches));
    }

    private static async Task WriteInputsAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        foreach (var axis in (await machine.ReadAsync(cancellation).ConfigureAwait(false)).Axes)
            machine.Context.WriteMessage(Wording.Get("Commission.Inputs", axis.Letter, State(axis.ForwardHit), State(axis.ReverseHit), axis.Home is { } home ? home ? "1" : "0" : "?"), MessageKind.Result);
    }

    private static string State(bool? hit) => hit is { } known ? Wording.Get(known ? "Commission.SwitchActive" : "Commission.SwitchInactive") : "?";
}
