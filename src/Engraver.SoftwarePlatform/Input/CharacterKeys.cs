using Avalonia.Input;

namespace Engraver.SoftwarePlatform.Input;

/// <summary>The key for a character on a US keyboard.</summary>
internal static class CharacterKeys
{
    /// <returns><see cref="Key.None"/> for a character without a key of its own.</returns>
    public static Key KeyOf(int character) => character switch
    {
        >= 'a' and <= 'z' => Key.A + (character - 'a'),
        >= 'A' and <= 'Z' => Key.A + (character - 'A'),
        >= '0' and <= '9' => Key.D0 + (character - '0'),
        ' ' => Key.Space,
        ',' or '<' => Key.OemComma,
        '.' or '>' => Key.OemPeriod,
        '-' or '_' => Key.OemMinus,
        '+' or '=' => Key.OemPlus,
        '/' or '?' => Key.OemQuestion,
        ';' or ':' => Key.OemSemicolon,
        '[' or '{' => Key.OemOpenBrackets,
        ']' or '}' => Key.OemCloseBrackets,
        '\\' or '|' => Key.OemPipe,
        '`' or '~' => Key.OemTilde,
        '\'' or '"' => Key.OemQuotes,
        _ => Key.None,
    };
}
