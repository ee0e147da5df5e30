using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Verification;

namespace Engraver.Cli.Options;

/// <summary>With what a program was posted that is read back, for a target whose post has it: <c>--origin</c>, <c>--blend</c> and what it says beside the
/// way.</summary>
internal sealed class PostParameterOptions
{
    private readonly IReadOnlyList<Option<string?>> _options = [.. PostParameters.OptionNames.Select(New)];

    /// <param name="target">The name of the target by what was typed; also one that posts nothing.</param>
    public void AddTo(Command command, Func<CommandResult, string> target)
    {
        foreach (var option in _options)
        {
            command.Options.Add(option);
            command.Validators.Add(result => Check(result, option, target(result)));
        }
    }

    public PostParameters Of(ParseResult parsed) => PostParameters.Parse(name => parsed.GetValue(_options.First(option => option.Name == "--" + name)));

    private static Option<string?> New(string name)
    {
        var choice = PostTable.Options.First(option => option.Name == name);
        var meaning = name switch { "origin" => Wording.Get("Verify.Origin"), "blend" => Wording.Get("Verify.Blend"), _ => Wording.Get("Verify.Posted", choice.Summary, choice.Default) };
        return new Option<string?>("--" + name) { HelpName = name == "origin" ? "here|X,Y[,Z]" : choice.Argument, Description = meaning };
    }

    /// <summary>Refuses what the target's post does not have, and a value that it would refuse.</summary>
    private static void Check(CommandResult result, Option<string?> option, string target)
    {
        if (result.GetResult(option) is not { Tokens: [var given] }) return;
        var post = PostTable.All.FirstOrDefault(entry => entry.Post.Name == target)?.Post;
        if (post?.Options.FirstOrDefault(one => "--" + one.Name == option.Name) is not { } choice) result.AddError(Wording.Get("Post.OptionNotSupported", option.Name, target));
        else if (!choice.IsValid(given.Value)) result.AddError(Wording.Get("Post.InvalidOption", choice.Name, given.Value, choice.Form));
    }
}
