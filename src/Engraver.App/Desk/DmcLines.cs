using Engraver.Galil.Programs;

namespace Engraver.App.Desk;

/// <summary>A posted program cut into lines once.</summary>
internal sealed record DmcLines(DmcPostText? Program, IReadOnlyList<string> Lines)
{
    public static DmcLines None { get; } = new(null, []);

    public DmcLines Of(DmcPostText? program)
    {
        if (ReferenceEquals(program, Program)) return this;
        return program is null ? None : new DmcLines(program, program.Text.TrimEnd('\n').Split('\n'));
    }
}
