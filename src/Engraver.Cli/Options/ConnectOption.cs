using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Cli.Options;

/// <summary><c>--connect</c>: where a controller is.</summary>
internal static class ConnectOption
{
    public static Option<ControllerAddress?> New(bool required, string description) =>
        new("--connect") { Required = required, HelpName = "URL", Description = description, CustomParser = Parse };

    private static ControllerAddress? Parse(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (!MachineFamilies.Standard.TryParseAddress(word, out var address))
        {
            result.AddError(Wording.Get("ConnectOption.Connect", MachineFamilies.Standard.NotAnAddress(word)));
            return null;
        }

        if (MachineFamilies.Standard.At(address, profile: null).RefusalOf(address) is { } why) result.AddError(Wording.Get("ConnectOption.Connect", why));
        return address;
    }
}
