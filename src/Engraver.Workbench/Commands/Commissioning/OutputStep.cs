using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>Finds the output that switches the tool.</summary>
internal sealed class OutputStep : ICommissioningStep
{
    public string Name => Wording.Get("Commission.OutputStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        var prompt = new NumberPrompt(Wording.Get("Commission.EnterToolOutput", machine.Profile.ToolOutput)) { Min = 1.0, Max = MachineFamilies.DriverOf(machine.Profile).Limits.Outputs, IsInteger = true, EnterEnds = true };
        while (await machine.Context.AskAsync(prompt).ConfigureAwait(false) is Answer<double>.Value { Result: var typed })
        {
            var output = (int)typed;
            if (!await machine.SwitchAllOnAsync(cancellation).ConfigureAwait(false)) return false;
            if (machine.Context.Machine.Status.Outputs is { } outputs && (outputs & (1 << (output - 1))) != 0)
            {
                machine.Context.WriteMessage(Wording.Get("Commission.OutputIsOn", output), MessageKind.Warning);
                continue;
            }

            if (!await machine.Context.ConfirmAsync(Wording.Get("Commission.ConfirmOutput", output)).ConfigureAwait(false)) continue;
            if (!await machine.Moves.PulseAsync(output, cancellation).ConfigureAwait(false)) return false;
            if (!await machine.Context.ConfirmAsync(Wording.Get("Commission.ConfirmToolSwitched")).ConfigureAwait(false)) continue;
            machine.Profile = machine.Profile with { ToolOutput = output };
            machine.Context.WriteMessage(Wording.Get("Commission.ToolOutputSet", output), MessageKind.Result);
            break;
        }

        return true;
    }
}
