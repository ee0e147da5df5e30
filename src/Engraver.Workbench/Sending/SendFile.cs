using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Core.Posts.Agie;
using Engraver.Core.Sending;

namespace Engraver.Workbench.Sending;

/// <summary>A program file to send. A file with the name of a wire EDM program may contain several programs, which the control accepts one at a time.</summary>
public sealed class SendFile
{
    private readonly bool _isAgie;

    private SendFile(IReadOnlyList<IReadOnlyList<ReadOnlyMemory<byte>>> programs, bool isAgie) => (Programs, _isAgie) = (programs, isAgie);

    /// <summary>Lines of each program.</summary>
    public IReadOnlyList<IReadOnlyList<ReadOnlyMemory<byte>>> Programs { get; }

    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public static SendFile Read(string path)
    {
        var isAgie = path.EndsWith(new AgiePost().FileExtension, StringComparison.OrdinalIgnoreCase);
        var lines = SendText.Lines(File.ReadAllBytes(path));
        return new SendFile(isAgie ? SendText.AgiePrograms(lines) : [lines], isAgie);
    }

    /// <summary>Encodes one program for the line.</summary>
    /// <param name="program">From 1; null if the file contains one.</param>
    public SendEncoding Encode(int? program, SendFormat format, CharacterFrame frame)
    {
        if (program is null && Programs.Count > 1) return new SendEncoding(null, SendingRules.SeveralPrograms.At(default, NumberText.Whole(Programs.Count)));
        if (program is < 1 || program > Programs.Count) return new SendEncoding(null, SendingRules.NoSuchProgram.At(default, NumberText.Whole(program.Value), NumberText.Whole(Programs.Count)));
        var lines = Programs[(program ?? 1) - 1];
        return _isAgie && SendText.TooLong(lines) is { } tooLong ? new SendEncoding(null, tooLong) : SendText.Encode(lines, format, frame);
    }
}
