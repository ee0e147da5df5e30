using Engraver.Core.Machines;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Questions with numbers for answers.</summary>
public static class ChannelQuestions
{
    /// <summary>MG of a list of operands, for example <c>_RPA,_RPB,TIME</c>; as many numbers come back as were asked for.</summary>
    /// <exception cref="ProtocolViolationException">The answer is not that many numbers.</exception>
    public static async ValueTask<Reading> ReadAsync(this CommandChannel channel, string operands, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(channel);
        ArgumentNullException.ThrowIfNull(operands);
        var reply = await channel.SendAsync("MG " + operands, cancellation).ConfigureAwait(false);
        if (reply is not Accepted { Data: var data }) return new Reading([], reply as Rejected);
        if (!ControllerNumber.TryParseAll(data, out var values) || values.Length != operands.AsSpan().Count(',') + 1)
            throw new ProtocolViolationException(Wording.Get("ChannelQuestions.ControllerAnsweredMg", data, operands));
        return new Reading(values, null);
    }

    /// <summary>MG of one operand that is a whole number, in a format of its own: before the session has set VF the owner's would cut it off (VF 4.0 prints 256000 as 9999) or print it in hexadecimal.</summary>
    /// <exception cref="ProtocolViolationException">The answer is no number.</exception>
    internal static ValueTask<Reading> ReadWholeAsync(this CommandChannel channel, string operand, CancellationToken cancellation) => channel.ReadAsync(operand + "{F10.0}", cancellation);
}

/// <summary>The numbers that answered a question, or the refusal to answer it.</summary>
public readonly record struct Reading(IReadOnlyList<double> Values, Rejected? Refusal)
{
    /// <summary>The single number of a question with one operand, or null when the controller does not know it: such a feature is not fitted.</summary>
    public double? OrNothing => Refusal is null ? Values[0] : null;
}
