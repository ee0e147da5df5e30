using System.CommandLine;
using Engraver.Core.Sending;

namespace Engraver.Cli.Verbs.Sending;

/// <summary>The serial line of a verb that sends or receives a program.</summary>
internal static class LineOption
{
    public static Option<SendAddress?> New(string name, string description) => new(name)
    {
        Required = true,
        HelpName = "URL",
        Description = description,
        CustomParser = result =>
        {
            if (SendAddress.TryParse(result.Tokens[0].Value, out var address)) return address;
            result.AddError(Wording.Get("Send.InvalidLine", name, result.Tokens[0].Value, SendAddress.Forms));
            return null;
        },
    };
}
