using Engraver.Core.Machines;
using Engraver.Core.Machines.Setup;
using Engraver.Galil.Jobs;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Setup;

/// <summary>Motor types, encoders, switches and error limits of a controller of the DMC family (galil-dmc.md C, "Per-axis commands": MT, CE, CN, ER, OE,
/// SH, MO).</summary>
internal sealed class GalilSetup(ControllerSession session) : IMachineSetup
{
    /// <summary>Samples of half a second (galil-dmc.md C, TIME).</summary>
    private const double WatchedSamples = 512.0;

    /// <summary>A motor that is switched on uses its position as the command (SH), so that its error starts at 0: beyond these counts it runs away, at any
    /// ER.</summary>
    private const double LargestErrorAtRest = 2000.0;

    public async ValueTask<SetupFacts> ReadAsync(string letters, CancellationToken cancellation)
    {
        var axes = new List<AxisFacts>();
        foreach (var letter in letters) axes.Add(await AxisAsync(letter, cancellation).ConfigureAwait(false));
        return new SetupFacts(
            DmcSetup.Sense(await AskAsync("_CN0", cancellation).ConfigureAwait(false)), DmcSetup.Sense(await AskAsync("_CN1", cancellation).ConfigureAwait(false)), axes);
    }

    public async Task<string?> SetAsync(SetupValue value, CancellationToken cancellation)
    {
        if (DmcSetup.NeedsMotorOff(value) is { } axis && await AskAsync($"_MO{axis}", cancellation).ConfigureAwait(false) is not 1.0) return Wording.Get("GalilSetup.MotorOn", axis);
        var operand = DmcSetup.Operand(value);
        if (await AskAsync(operand, cancellation).ConfigureAwait(false) is not { } found) return Wording.Get("GalilSetup.NotReported", operand);
        var wanted = DmcSetup.Number(value, found);
        if (await session.Commands.SendAsync(DmcSetup.Command(value, wanted), cancellation).ConfigureAwait(false) is Rejected refused) return refused.Explain();
        if (await AskAsync(operand, CancellationToken.None).ConfigureAwait(false) is var has && has == wanted) return null;
        await session.Commands.SendAsync(DmcSetup.Command(value, found), CancellationToken.None).ConfigureAwait(false);
        return Wording.Get("GalilSetup.ValueNotAccepted", DmcSetup.Command(value, wanted), has ?? double.NaN);
    }

    public async Task<string?> SwitchMotorAsync(char axis, bool on, CancellationToken cancellation)
    {
        if (await session.Commands.SendAsync((on ? "SH" : "MO") + axis, cancellation).ConfigureAwait(false) is Rejected refused) return refused.Explain();
        return on ? await WatchAsync(axis).ConfigureAwait(false) : null;
    }

    public Task<JobResult> PulseAsync(MotionProgram program, JobOptions options, CancellationToken stop) => JobRunner.PulseAsync(program, session, options, stop);

    public async Task<string?> BurnAsync(CancellationToken cancellation) => (await session.BurnAsync(cancellation).ConfigureAwait(false))?.Explain();

    /// <summary>Polls as fast as the link allows, by the controller's own clock. Not cancellable: half a second is short, and a motor that runs away must be
    /// stopped.</summary>
    private async Task<string?> WatchAsync(char axis)
    {
        var limit = await AskAsync($"_ER{axis}", CancellationToken.None).ConfigureAwait(false) is > 0.0 and var counts ? Math.Min(counts, LargestErrorAtRest) : LargestErrorAtRest;
        var hasLoop = Math.Abs(await AskAsync($"_MT{axis}", CancellationToken.None).ConfigureAwait(false) ?? 1.0) < 2.0; // a stepper has no following error (galil-dmc.md C, TE)
        for (double? begun = null; ;)
        {
            var look = await session.Commands.ReadAsync($"TIME,_TE{axis},_MO{axis}", CancellationToken.None).ConfigureAwait(false);
            if (look.Refusal is { } refused) throw new ProtocolViolationException(refused.Explain());
            if (look.Values[2] != 0.0 || (hasLoop && Math.Abs(look.Values[1]) > limit))
            {
                await session.Commands.SendAsync($"MO{axis}", CancellationToken.None).ConfigureAwait(false);
                return Wording.Get("GalilSetup.RanAway", axis, look.Values[1]);
            }

            begun ??= look.Values[0];
            if (look.Values[0] - begun is < 0.0 or >= WatchedSamples) return null;
        }
    }

    private async Task<AxisFacts> AxisAsync(char letter, CancellationToken cancellation)
    {
        var motor = DmcSetup.Motor(await AskAsync($"_MT{letter}", cancellation).ConfigureAwait(false));
        var encoder = DmcSetup.Encoder(await AskAsync($"_CE{letter}", cancellation).ConfigureAwait(false));
        var limit = await AskAsync($"_ER{letter}", cancellation).ConfigureAwait(false);
        var off = await AskAsync($"_OE{letter}", cancellation).ConfigureAwait(false);
        var place = await AskAsync($"_RP{letter}", cancellation).ConfigureAwait(false) ?? throw new ProtocolViolationException(Wording.Get("GalilSetup.NotReported", $"_RP{letter}"));
        var error = await AskAsync($"_TE{letter}", cancellation).ConfigureAwait(false) ?? 0.0;

        // _LF and _LR are 1 when motion is allowed, by the present CN (galil-dmc.md C.1).
        async Task<bool?> Is(string operand, double level) => await AskAsync(operand + letter, cancellation).ConfigureAwait(false) is { } value ? value == level : null;
        return new AxisFacts(letter, motor, encoder, (int?)limit, off is { } reaction ? ((int)reaction & 1) != 0 : null, (int)place, (int)error)
        {
            IsMotorOff = await Is("_MO", 1.0).ConfigureAwait(false) ?? false,
            ForwardHit = await Is("_LF", 0.0).ConfigureAwait(false),
            ReverseHit = await Is("_LR", 0.0).ConfigureAwait(false),
            Home = await Is("_HM", 1.0).ConfigureAwait(false),
        };
    }

    /// <summary>One number with one decimal, in any number format of the session (MT 2.5).</summary>
    private async ValueTask<double?> AskAsync(string operand, CancellationToken cancellation) => (await session.Commands.ReadAsync(operand + "{F10.1}", cancellation).ConfigureAwait(false)).ValuesOrEmpty;
}
