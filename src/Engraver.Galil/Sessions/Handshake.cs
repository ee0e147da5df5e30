using Engraver.Core.Machines;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>The first queries on a new connection (galil-dmc.md F.2); none of them changes the controller.</summary>
internal static class Handshake
{
    private const string RevisionQuestion = "\x12\x16";

    /// <exception cref="ProtocolViolationException">The replies are not those of a controller of the DMC family.</exception>
    public static async Task<ControllerIdentity> IdentifyAsync(CommandChannel channel, CancellationToken cancellation)
    {
        var model = await TextAsync(channel, RevisionQuestion, cancellation).ConfigureAwait(false);
        var (axes, family, isSimulated) = ControllerModel.Parse(model) ?? throw new ProtocolViolationException(Wording.Get("Handshake.NotDmcController", model));
        if (axes < 2) throw new ProtocolViolationException(Wording.Get("Handshake.OneAxis", model));
        var handle = await TextAsync(channel, "WH", cancellation).ConfigureAwait(false);
        var record = await RecordBytesAsync(channel, axes, cancellation).ConfigureAwait(false);
        await channel.SendAsync("TC1", cancellation).ConfigureAwait(false);
        return new ControllerIdentity(model, axes, handle, record, await LimitsAsync(channel, cancellation).ConfigureAwait(false)) { UntriedFamily = isSimulated ? null : family };
    }

    private static async Task<string> TextAsync(CommandChannel channel, string question, CancellationToken cancellation) =>
        await channel.SendAsync(question, cancellation).ConfigureAwait(false) is Accepted { Data: var text } ? text : "";

    /// <summary>QZ: axes, bytes of the general, coordinated and axis blocks. The first number is not used, because EPICS uses the digit of the model as
    /// well.</summary>
    /// <returns>Null when the query is refused: the controller has no such record.</returns>
    private static async Task<int?> RecordBytesAsync(CommandChannel channel, int axes, CancellationToken cancellation)
    {
        if (await channel.SendAsync("QZ", cancellation).ConfigureAwait(false) is not Accepted { Data: var answer }) return null;
        if (!ControllerNumber.TryParseAll(answer, out var blocks) || blocks.Length != 4)
            throw new ProtocolViolationException(Wording.Get("Handshake.UnexpectedReplyToQZ", answer));
        return 4 + (int)blocks[1] + (int)blocks[2] + (axes * (int)blocks[3]);
    }

    private static async Task<ControllerLimits> LimitsAsync(CommandChannel channel, CancellationToken cancellation)
    {
        async Task<int?> Ask(string operand) => (int?)(await channel.ReadWholeAsync(operand, cancellation).ConfigureAwait(false)).ValuesOrEmpty;
        return new ControllerLimits(
            await Ask("_DL").ConfigureAwait(false),
            await Ask("_UL").ConfigureAwait(false),
            await Ask("_DM").ConfigureAwait(false),
            await Ask("_IA2").ConfigureAwait(false),
            await Ask("_LMS").ConfigureAwait(false),
            await Ask("_TM").ConfigureAwait(false));
    }
}
