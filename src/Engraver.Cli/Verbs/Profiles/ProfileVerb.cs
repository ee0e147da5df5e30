using System.CommandLine;
using Engraver.Cli.Output;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs.Profiles;

/// <summary><c>engraver profile check</c>: the meaning of a machine profile and all its errors.</summary>
internal static class ProfileVerb
{
    public static Command Build(VerbHost host)
    {
        var file = new Argument<string>("FILE") { Description = Wording.Get("Profile.File") };
        var json = JsonOption.New();
        var check = new Command("check", Wording.Get("Profile.Check")) { file, json };
        check.SetAction((parsed, _) =>
        {
            var path = parsed.GetRequiredValue(file);
            var read = MachineProfileSource.Read(path, MachineFamilies.Standard);
            IReadOnlyList<string> meaning = read.Profile is { } profile ? ProfileMeaning.Of(profile) : [];
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, ProfileJson.From(path, read, meaning), ProfileContract.Default.ProfileJson);
            else foreach (var sentence in meaning) host.Out.WriteLine(sentence);
            return Task.FromResult(host.Report(parsed, path, read.Diagnostics));
        });
        return new Command("profile", Wording.Get("Profile.Machine")) { check };
    }
}
