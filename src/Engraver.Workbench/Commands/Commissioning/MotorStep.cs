using Engraver.Core.Machines.Setup;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>Sets the motor type of each axis and its sense.</summary>
internal sealed class MotorStep : ICommissioningStep
{
    private static readonly IReadOnlyList<Keyword> s_signals = Keyword.List("Servo", "Low", "High");

    public string Name => Wording.Get("Commission.MotorStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        foreach (var axis in (await machine.ReadAsync(cancellation).ConfigureAwait(false)).Axes)
        {
            if (axis.Motor is not { } found)
            {
                machine.Context.WriteMessage(Wording.Get("Commission.MotorUnknown", axis.Letter), MessageKind.Warning);
                continue;
            }

            var was = found.Signal switch { MotorSignal.Servo => "Servo", MotorSignal.LowPulses => "Low", _ => "High" };
            var signal = await machine.Context.ChoiceAsync(Wording.Get("Commission.EnterMotorSignal", axis.Letter), s_signals, was).ConfigureAwait(false) switch { "Servo" => MotorSignal.Servo, "Low" => MotorSignal.LowPulses, _ => MotorSignal.HighPulses };
            var type = new MotorType(signal, await SensePrompt.AskAsync(machine.Context, Wording.Get("Commission.EnterMotorDirection", axis.Letter), found.IsReversed).ConfigureAwait(false));
            if (type == found || !await machine.SwitchOffAsync(axis.Letter, cancellation).ConfigureAwait(false)) continue;
            await machine.AcceptAsync(new SetupValue.Motor(axis.Letter, type), Wording.Get("Commission.MotorSet", axis.Letter, TypeText(type)), cancellation).ConfigureAwait(false);
        }

        return true;
    }

    private static string TypeText(MotorType type) => Wording.Get((type.Signal, type.IsReversed) switch
    {
        (MotorSignal.Servo, false) => "Commission.Servo",
        (MotorSignal.Servo, true) => "Commission.ServoReversed",
        (MotorSignal.LowPulses, false) => "Commission.LowPulses",
        (MotorSignal.LowPulses, true) => "Commission.LowPulsesReversed",
        (_, false) => "Commission.HighPulses",
        (_, true) => "Commission.HighPulsesReversed",
    });
}
