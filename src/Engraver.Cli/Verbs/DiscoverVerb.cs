using System.CommandLine;
using System.Globalization;
using Engraver.Cli.Output;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver discover</c>: lists the controllers that answer.</summary>
internal static class DiscoverVerb
{
    public static Command Build(VerbHost host)
    {
        var addresses = new Argument<string[]>("URL") { Arity = ArgumentArity.ZeroOrMore, Description = Wording.Get("Discover.Address") };
        addresses.Validators.Add(result =>
        {
            foreach (var token in result.Tokens)
            {
                if (!MachineFamilies.Standard.TryParseAddress(token.Value, out _)) result.AddError(MachineFamilies.Standard.NotAnAddress(token.Value));
            }
        });
        var baud = new Option<int>("--baud") { HelpName = "N", Description = Wording.Get("Discover.Baud"), DefaultValueFactory = _ => ControllerAddress.DefaultBaud };
        baud.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && !(int.TryParse(token.Value, NumberStyles.None, CultureInfo.InvariantCulture, out var rate) && SerialLine.Rates.Contains(rate))) result.AddError(Wording.Get("Simulate.InvalidBaud", token.Value, string.Join(", ", SerialLine.Rates)));
        });
        var json = JsonOption.New();
        var command = new MachineCommand("discover", Wording.Get("Discover.Summary")) { addresses, baud, json };
        command.SetAction((parsed, stop) => RunAsync(host, parsed.GetValue(addresses) ?? [], parsed.GetValue(baud), parsed.GetValue(json), stop));
        return command;
    }

    private static async Task<int> RunAsync(VerbHost host, string[] given, int baud, bool json, CancellationToken stop)
    {
        var asked = new List<DiscoveredController>();
        foreach (var address in Discovery.Candidates(given, baud, Discovery.UserSettings, Discovery.Devices))
        {
            var one = await Discovery.QueryAsync(address, TimeProvider.System, stop).ConfigureAwait(false);
            asked.Add(one);
            if (!json) host.Out.WriteLine(one switch
            {
                { Model: null } => Wording.Get("Discover.NoReply", one.Address, one.Failure),
                { Serial: { } number } => Wording.Get("Discover.Found", one.Address, one.Model, number),
                _ => Wording.Get("Discover.FoundWithoutNumber", one.Address, one.Model),
            });
        }

        if (json) ContractJson.Write(host.Out, DiscoverJson.From(asked), ContractJson.Default.DiscoverJson);
        if (asked.Any(one => one.Model is not null)) return ExitCode.Done;
        if (asked.Count == 0) host.Error.WriteLine(Wording.Get("Discover.NoAddress"));
        return ExitCode.LinkLost;
    }
}
