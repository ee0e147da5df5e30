using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Verification;

namespace Engraver.Cli.Options;

/// <summary>With what a program was posted that is read back: <c>--origin</c> and <c>--blend</c>, for a target whose post has them.</summary>
internal sealed class PostedOptions
{
    private readonly Option<string?> _origin = new("--origin") { HelpName = "here|X,Y[,Z]", Description = Wording.Get("Verify.Origin") };
    private readonly Option<string?> _blend = new("--blend") { HelpName = "MM", Description = Wording.Get("Verify.Blend") };

    /// <param name="target">The name of the target by what was typed; also one that posts nothing.</param>
    public void AddTo(Command command, Func<CommandResult, string> target)
    {
        foreach (var option in (Option<string?>[])[_origin, _blend])
        {
            command.Options.Add(option);
            command.Validators.Add(result => Check(result, option, target(result)));
        }
    }

    public PostedWith Of(ParseResult parsed) => PostedWith.Parse(parsed.GetValue(_origin), parsed.GetValue(_blend));

    /// <summary>Refuses what the target's post does not have, and a value that it would refuse.</summary>
    private static void Check(CommandResult result, Option<string?> option, string target)
    {
        if (result.GetResult(option) is not { Tokens: [var given] }) return;
        var post = PostTable.All.FirstOrDefault(entry => entry.Post.Name == target)?.Post;
        if (post?.Options.FirstOrDefault(one => "--" + one.Name == option.Name) is not { } choice) result.AddError(Wording.Get("Post.NoOptionTarget", option.Name, target));
        else if (!choice.Takes(given.Value)) result.AddError(Wording.Get("Post.Not", choice.Name, given.Value, choice.Form));
    }
}
