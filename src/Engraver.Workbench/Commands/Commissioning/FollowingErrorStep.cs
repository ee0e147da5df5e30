using Engraver.Core.Machines.Setup;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>Sets the maximum following error, and whether the controller switches the motor off beyond it.</summary>
internal sealed class FollowingErrorStep : ICommissioningStep
{
    private static readonly IReadOnlyList<Keyword> s_answers = Keyword.List("Yes", "No");

    public string Name => Wording.Get("Commission.ErrorStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        foreach (var axis in (await machine.ReadAsync(cancellation).ConfigureAwait(false)).Axes)
        {
            if (axis.ErrorLimit is { } limit)
            {
                var prompt = new NumberPrompt(Wording.Get("Commission.EnterErrorLimit", axis.Letter, limit)) { Min = 1.0, Max = int.MaxValue, IsInteger = true, EnterEnds = true };
                if (await machine.Context.AskAsync(prompt).ConfigureAwait(false) is Answer<double>.Value { Result: var typed } && (int)typed != limit)
                    await machine.AcceptAsync(new SetupValue.ErrorLimit(axis.Letter, (int)typed), Wording.Get("Commission.ErrorLimitSet", axis.Letter, typed), cancellation).ConfigureAwait(false);
            }

            if (axis.OffOnError is not { } found) continue;
            var on = await machine.Context.ChoiceAsync(Wording.Get("Commission.EnterOffOnError", axis.Letter), s_answers, found ? "Yes" : "No").ConfigureAwait(false) == "Yes";
            if (on != found) await machine.AcceptAsync(new SetupValue.OffOnError(axis.Letter, on), Wording.Get(on ? "Commission.OffOnErrorSet" : "Commission.OffOnErrorCleared", axis.Letter), cancellation).ConfigureAwait(false);
        }

        return true;
    }
}
