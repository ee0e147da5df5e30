using Engraver.Core.Machines;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Queries for numbers.</summary>
public static class ChannelQueries
{
    /// <summary>MG of a list of operands, for example <c>_RPA,_RPB,TIME</c>; returns one number for each.</summary>
    /// <exception cref="ProtocolViolationException">The number of values in the reply differs from the number of operands.</exception>
    public static async ValueTask<QueryResult> ReadAsync(this CommandChannel channel, string operands, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(channel);
        ArgumentNullException.ThrowIfNull(operands);
        var reply = await channel.SendAsync("MG " + operands, cancellation).ConfigureAwait(false);
        if (reply is not Accepted { Data: var data }) return new QueryResult([], reply as Rejected);
        if (!ControllerNumber.TryParseAll(data, out var values) || values.Length != operands.AsSpan().Count(',') + 1)
            throw new ProtocolViolationException(Wording.Get("ChannelQueries.UnexpectedReplyToMG", data, operands));
        return new QueryResult(values, null);
    }

    /// <summary>MG of one operand that is a whole number, in a fixed format: before the session has set VF, the present format might truncate it (VF 4.0 prints
    /// 256000 as 9999) or print it in hexadecimal.</summary>
    /// <exception cref="ProtocolViolationException">The reply is not a number.</exception>
    internal static ValueTask<QueryResult> ReadWholeAsync(this CommandChannel channel, string operand, CancellationToken cancellation) => channel.ReadAsync(operand + "{F10.0}", cancellation);
}

/// <summary>The numbers in the reply to a query, or its refusal.</summary>
public readonly record struct QueryResult(IReadOnlyList<double> Values, Rejected? Refusal)
{
    /// <summary>The number in the reply to a query with one operand; null when the controller refuses it, because it does not have that feature.</summary>
    public double? ValuesOrEmpty => Refusal is null ? Values[0] : null;
}
