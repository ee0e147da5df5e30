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
                machine.Context.Say(Wording.Get("Commission.MotorUnknown", axis.Letter), MessageKind.Warning);
                continue;
            }

            var was = found.Signal switch { MotorSignal.Servo => "Servo", MotorSignal.LowPulses => "Low", _ => "High" };
            var signal = await machine.Context.ChoiceAsync(Wording.Get("Commission.EnterMotorSignal", axis.Letter), s_signals, was).ConfigureAwait(false) switch { "Servo" => MotorSignal.Servo, "Low" => MotorSignal.LowPulses, _ => MotorSignal.HighPulses };
            var type = new MotorType(signal, await Senses.AskAsync(machine.Context, Wording.Get("Commission.EnterMotorDirection", axis.Letter), found.IsReversed).ConfigureAwait(false));
            if (type == found || !await machine.SwitchOffAsync(axis.Letter, cancellation).ConfigureAwait(false)) continue;
            await machine.AcceptAsync(new SetupValue.Motor(axis.Letter, type), Wording.Get("Commission.MotorSet", axis.Letter, Said(type)), cancellation).ConfigureAwait(false);
        }

        return true;
    }

    private static string Said(MotorType type) => Wording.Get((type.Signal, type.IsReversed) switch
    {
        (MotorSignal.Servo, false) => "Commission.Servo",
        (MotorSignal.Servo, true) => "Commission.ServoReversed",
        (MotorSignal.LowPulses, false) => "Commission.LowPulses",
        (MotorSignal.LowPulses, true) => "Commission.LowPulsesReversed",
        (_, false) => "Commission.HighPulses",
        (_, true) => "Commission.HighPulsesReversed",
    });
}

/// <summary>Sets the encoder type of each axis and its sense.</summary>
internal sealed class EncoderStep : ICommissioningStep
{
    private static readonly IReadOnlyList<Keyword> s_signals = Keyword.List("Quadrature", "Pulse");

    public string Name => Wording.Get("Commission.EncoderStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        foreach (var axis in (await machine.ReadAsync(cancellation).ConfigureAwait(false)).Axes)
        {
            if (axis.Encoder is not { } found) continue;
            var answer = await machine.Context.ChoiceAsync(Wording.Get("Commission.EnterEncoderSignal", axis.Letter), s_signals, found.Signal == EncoderSignal.Quadrature ? "Quadrature" : "Pulse").ConfigureAwait(false);
            var signal = answer == "Quadrature" ? EncoderSignal.Quadrature : EncoderSignal.PulseAndDirection;
            var type = new EncoderType(signal, await Senses.AskAsync(machine.Context, Wording.Get("Commission.EnterEncoderDirection", axis.Letter), found.IsReversed).ConfigureAwait(false));
            if (type == found || !await machine.SwitchOffAsync(axis.Letter, cancellation).ConfigureAwait(false)) continue;
            await machine.AcceptAsync(new SetupValue.Encoder(axis.Letter, type), Wording.Get("Commission.EncoderSet", axis.Letter, Said(type)), cancellation).ConfigureAwait(false);
        }

        return true;
    }

    private static string Said(EncoderType type) => Wording.Get((type.Signal, type.IsReversed) switch
    {
        (EncoderSignal.Quadrature, false) => "Commission.Quadrature",
        (EncoderSignal.Quadrature, true) => "Commission.QuadratureReversed",
        (_, false) => "Commission.PulseAndDirection",
        (_, true) => "Commission.PulseAndDirectionReversed",
    });
}

/// <summary>The two senses of a motor or an encoder.</summary>
internal static class Senses
{
    private static readonly IReadOnlyList<Keyword> s_senses = Keyword.List("Normal", "Reversed");

    public static async Task<bool> AskAsync(CommandContext context, string instruction, bool isReversed) =>
        await context.ChoiceAsync(instruction, s_senses, isReversed ? "Reversed" : "Normal").ConfigureAwait(false) == "Reversed";
}

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
        await SayInputsAsync(machine, cancellation).ConfigureAwait(false);
        string answer;
        while ((answer = await machine.Context.ChoiceAsync(Wording.Get("Commission.EnterActiveLevel", switches), s_levels, found.ToString()).ConfigureAwait(false)) == "reAd") await SayInputsAsync(machine, cancellation).ConfigureAwait(false);
        var sense = Enum.Parse<SwitchSense>(answer);
        if (sense == found || !await machine.TryAsync(value(sense), cancellation).ConfigureAwait(false)) return;
        var isAccepted = false;
        try
        {
            await SayInputsAsync(machine, cancellation).ConfigureAwait(false);
            isAccepted = await machine.Context.ConfirmAsync(Wording.Get("Commission.ConfirmSwitches")).ConfigureAwait(false);
        }
        finally
        {
            if (!isAccepted) await machine.TryAsync(value(found), CancellationToken.None).ConfigureAwait(false);
        }

        if (isAccepted) machine.Accepted(value(sense), Wording.Get(sense == SwitchSense.Low ? "Commission.SwitchesLow" : "Commission.SwitchesHigh", switches));
    }

    private static async Task SayInputsAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        foreach (var axis in (await machine.ReadAsync(cancellation).ConfigureAwait(false)).Axes)
            machine.Context.Say(Wording.Get("Commission.Inputs", axis.Letter, State(axis.ForwardHit), State(axis.ReverseHit), axis.Home is { } home ? home ? "1" : "0" : "?"), MessageKind.Result);
    }

    private static string State(bool? hit) => hit is { } known ? Wording.Get(known ? "Commission.SwitchActive" : "Commission.SwitchInactive") : "?";
}

/// <summary>Sets the maximum following error, and whether the controller switches the motor off beyond it.</summary>
internal sealed class ErrorStep : ICommissioningStep
{
    private static readonly IReadOnlyList<Keyword> s_answers = Keyword.List("Yes", "No");

    public string Name => Wording.Get("Commission.ErrorStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        foreach (var axis in (await machine.ReadAsync(cancellation).ConfigureAwait(false)).Axes)
        {
            if (axis.ErrorLimit is { } limit)
            {
                var prompt = new NumberPrompt(Wording.Get("Commission.EnterErrorLimit", axis.Letter, limit)) { Least = 1.0, Most = int.MaxValue, Whole = true, EnterEnds = true };
                if (await machine.Context.AskAsync(prompt).ConfigureAwait(false) is Answer<double>.Value { Of: var typed } && (int)typed != limit)
                    await machine.AcceptAsync(new SetupValue.ErrorLimit(axis.Letter, (int)typed), Wording.Get("Commission.ErrorLimitSet", axis.Letter, typed), cancellation).ConfigureAwait(false);
            }

            if (axis.OffOnError is not { } found) continue;
            var on = await machine.Context.ChoiceAsync(Wording.Get("Commission.EnterOffOnError", axis.Letter), s_answers, found ? "Yes" : "No").ConfigureAwait(false) == "Yes";
            if (on != found) await machine.AcceptAsync(new SetupValue.OffOnError(axis.Letter, on), Wording.Get(on ? "Commission.OffOnErrorSet" : "Commission.OffOnErrorCleared", axis.Letter), cancellation).ConfigureAwait(false);
        }

        return true;
    }
}
