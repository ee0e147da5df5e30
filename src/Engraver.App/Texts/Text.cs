using Engraver.Core.Languages;

namespace Engraver.App.Texts;

/// <summary>The texts of the desktop.</summary>
public sealed class Text : ProjectTexts<Text>;
