using Engraver.Core.Machines.Setup;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Commissioning;

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
            var type = new EncoderType(signal, await SensePrompt.AskAsync(machine.Context, Wording.Get("Commission.EnterEncoderDirection", axis.Letter), found.IsReversed).ConfigureAwait(false));
            if (type == found || !await machine.SwitchOffAsync(axis.Letter, cancellation).ConfigureAwait(false)) continue;
            await machine.AcceptAsync(new SetupValue.Encoder(axis.Letter, type), Wording.Get("Commission.EncoderSet", axis.Letter, TypeText(type)), cancellation).ConfigureAwait(false);
        }

        return true;
    }

    private static string TypeText(EncoderType type) => Wording.Get((type.Signal, type.IsReversed) switch
    {
        (EncoderSignal.Quadrature, false) => "Commission.Quadrature",
        (EncoderSignal.Quadrature, true) => "Commission.QuadratureReversed",
        (_, false) => "Commission.PulseAndDirection",
        (_, true) => "Commission.PulseAndDirectionReversed",
    });
}
